#include "host/scene_text/values/names.hpp"

#include "core/bytes/code_point.hpp"
#include "core/scene/kfb_limits.hpp"
#include "host/kdl/code_point_class.hpp"

#include <algorithm>

namespace kfast::scene_text {
namespace {

constexpr std::size_t longest = kfb::max_name_bytes;

bool may_stand(CodePoint point)
{
    return point.valid && point.value >= 0x20 && point.value != 0x7F && !kdl::is_disallowed(point.value) &&
           !kdl::is_newline(point.value);
}

/// Not in the middle of a code point.
std::string_view cut(std::string_view name, std::size_t bytes)
{
    std::size_t end = 0;
    while (end < name.size()) {
        const std::size_t next = end + code_point_at(name, end).length;
        if (next > bytes)
            break;
        end = next;
    }
    return name.substr(0, end);
}

std::string_view trimmed(std::string_view name)
{
    const std::size_t begin = std::min(name.find_first_not_of(' '), name.size());
    const std::size_t end = name.find_last_not_of(' ');
    return end == std::string_view::npos ? std::string_view{} : name.substr(begin, end - begin + 1);
}

}

std::string clean_name(std::string_view name, std::string_view default_value)
{
    std::string clean;
    for (std::size_t at = 0; at < name.size();) {
        const CodePoint point = code_point_at(name, at);
        clean += may_stand(point) ? std::string{name.substr(at, point.length)} : " ";
        at += point.length;
    }
    const std::string_view kept = trimmed(cut(trimmed(clean), longest));
    return std::string{kept.empty() ? default_value : kept};
}

std::string Names::unique(std::string_view name, std::string_view default_value)
{
    std::string clean = clean_name(name, default_value);
    if (taken_.insert(clean).second)
        return clean;
    std::size_t& count = counts_.try_emplace(clean, 1).first->second;
    while (true) {
        const std::string number = '-' + std::to_string(++count);
        std::string numbered = std::string{cut(clean, longest - number.size())} + number;
        if (taken_.insert(numbered).second)
            return numbered;
    }
}

}

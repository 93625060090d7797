#include "host/schema/variable_names.hpp"

#include "host/schema/arithmetic.hpp"

#include <algorithm>
#include <cstddef>

namespace kfast::schema {

namespace {

constexpr bool is_in_name(char letter) { return begins_name(letter) || is_digit(letter); }

}

std::size_t name_end(std::string_view text, std::size_t begin)
{
    return static_cast<std::size_t>(
        std::find_if_not(text.begin() + static_cast<std::ptrdiff_t>(begin), text.end(), is_in_name) -
        text.begin());
}

std::vector<std::string_view> names_in(std::string_view text)
{
    std::vector<std::string_view> names;
    for (std::size_t at = 0; at < text.size();) {
        if (!is_in_name(text[at])) {
            ++at;
            continue;
        }
        const std::size_t end = name_end(text, at);
        const std::string_view name = text.substr(at, end - at);
        if (is_variable_name(name))
            names.push_back(name);
        at = end;
    }
    return names;
}

std::string_view name_in_front(std::string_view text)
{
    return text.empty() || !begins_name(text.front()) ? std::string_view{}
                                                      : text.substr(0, name_end(text, 0));
}

bool is_variable_name(std::string_view name)
{
    return !name.empty() && begins_name(name.front()) && name_end(name, 0) == name.size() &&
           function_called(name) == nullptr;
}

}

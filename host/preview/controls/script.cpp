#include "host/preview/controls/script.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace kfast {
namespace {

struct Named {
    std::string_view name;
    ScriptStep::Kind kind;
    bool is_number;
};

constexpr std::array names{
    Named{"frame=", ScriptStep::Kind::frame, true},
    Named{"select=", ScriptStep::Kind::select, false},
    Named{"open=", ScriptStep::Kind::open, false},
    Named{"wait=", ScriptStep::Kind::wait, true},
};

constexpr double largest_number = 1e6;

std::optional<double> read_number(std::string_view text)
{
    double number = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number, std::chars_format::fixed);
    const bool is_number = error == std::errc{} && rest == end;
    return is_number && number >= 0 && number <= largest_number ? std::optional{number} : std::nullopt;
}

}

std::optional<ScriptStep> script_step(std::string_view word)
{
    if (const auto key = preview_key(word))
        return ScriptStep{.key = *key};
    const auto* const found =
        std::ranges::find_if(names, [word](const Named& row) { return word.starts_with(row.name); });
    if (found == names.end())
        return std::nullopt;
    const std::string_view value = word.substr(found->name.size());
    if (!found->is_number)
        return ScriptStep{.kind = found->kind, .text = std::string{value}};
    const auto number = read_number(value);
    return number ? std::optional{ScriptStep{.kind = found->kind, .number = *number}} : std::nullopt;
}

}

#include "host/scene/values/number_pattern.hpp"

#include "core/scene/kfb_limits.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/text/characters.hpp"

#include <algorithm>
#include <string_view>

namespace kfast::scene {
namespace {

constexpr std::u32string_view of_digits = U"#_0";
constexpr std::u32string_view of_decimals = U"#0";
constexpr std::u32string_view points = U".,";

constexpr auto hint = "write a digit as #, _ or 0, and what stands around it, as in \"##0.0 km/h\"";

std::u32string characters_of(std::string_view text)
{
    std::u32string characters;
    for (std::size_t at = 0; at < text.size();) {
        const CodePoint point = code_point_at(text, at);
        characters += point.value;
        at += point.length;
    }
    return characters;
}

bool has(std::u32string_view text, char32_t character) { return text.find(character) != text.npos; }

/// Takes as many characters in front of `text` as are among `known`.
std::u32string_view take(std::u32string_view& text, std::u32string_view known)
{
    const std::size_t count = std::min(text.find_first_not_of(known), text.size());
    const std::u32string_view taken = text.substr(0, count);
    text.remove_prefix(count);
    return taken;
}

/// Takes the point and the decimals.
void take_decimals(std::u32string_view& text, NumberPattern& pattern)
{
    if (text.size() < 2 || !has(points, text[0]) || !has(of_decimals, text[1]))
        return;
    pattern.point = text[0];
    text.remove_prefix(1);
    pattern.decimals = static_cast<std::uint32_t>(take(text, of_decimals).size());
}

bool is_line(std::u32string_view text)
{
    return std::ranges::none_of(text,
                                [](char32_t character) { return character < U' ' || character == 0x7F; });
}

}

std::optional<NumberPattern> read_number_pattern(const kdl::Value& value, SceneContext& context)
{
    const auto written = read_text(value, context.report);
    if (!written)
        return std::nullopt;
    const auto refuse = [&](std::string message) {
        context.report.error(value.place, std::move(message), hint);
        return std::nullopt;
    };
    const std::u32string text = characters_of(*written);
    std::u32string_view rest = text;
    NumberPattern pattern;
    pattern.before = rest.substr(0, std::min(rest.find_first_of(of_digits), rest.size()));
    rest.remove_prefix(pattern.before.size());
    const std::u32string_view digits = take(rest, of_digits);
    if (digits.empty())
        return refuse("this format has no digit");
    const auto zeros = static_cast<std::uint32_t>(std::ranges::count(digits, U'0'));
    if (has(digits.substr(0, digits.size() - zeros), U'0'))
        return refuse("# and _ stand in front of 0");
    pattern.digits = std::max(zeros, 1U);
    if (has(digits, U'_'))
        pattern.places = static_cast<std::uint32_t>(digits.size());
    take_decimals(rest, pattern);
    pattern.behind = rest;
    if (digits.size() > kfb::max_digits || pattern.decimals > kfb::max_decimals)
        return refuse("a number has at most 10 digits before the point and 3 behind it");
    if (pattern.before.size() + pattern.behind.size() > kfb::max_around)
        return refuse("at most " + std::to_string(kfb::max_around) + " characters stand around a number");
    if (!is_line(text))
        return refuse("a format is one line of visible characters");
    return pattern;
}

}

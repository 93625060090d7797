#include "host/commands/inputs/input_value.hpp"

#include "host/commands/text/glyph_text.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/text/characters.hpp"

#include <charconv>

namespace kfast {

std::optional<std::int32_t> read_input_value(std::string_view text, const InputView& input)
{
    const std::string_view number = text.substr(text.starts_with('+') ? 1 : 0);
    double value = 0;
    const auto [rest, error] = std::from_chars(number.data(), number.data() + number.size(), value);
    const bool is_whole = error == std::errc{} && rest == number.data() + number.size();
    if (!is_whole || !(value >= input.min / 1000.0 && value <= input.max / 1000.0))
        return std::nullopt;
    return scene::thousandths(value);
}

std::string input_value_mistake(std::string_view text, const InputView& input)
{
    return "'" + visible(text) + "' is no value of " + visible(input.name) + ": it goes from " +
           scene::text_of(input.min / 1000.0) + " to " + scene::text_of(input.max / 1000.0);
}

std::optional<std::string> input_text_mistake(std::string_view text, std::string_view name, std::size_t max,
                                              const std::optional<GlyphSet>& glyphs)
{
    std::size_t count = 0;
    for (std::size_t at = 0; at < text.size(); ++count) {
        const CodePoint point = code_point_at(text, at);
        if (!point.valid)
            return "'" + visible(text) + "' is no UTF-8";
        if (glyphs && !glyphs->glyph(point.value))
            return visible(name) + " has no " + in_quotes(text.substr(at, point.length)) +
                   ": its characters are " + in_quotes(glyph_text(*glyphs)) + " and the space";
        at += point.length;
    }
    if (count <= max)
        return std::nullopt;
    return "'" + visible(text) + "' has " + std::to_string(count) + " characters: " + visible(name) +
           " has " + std::to_string(max) + " at most";
}

}

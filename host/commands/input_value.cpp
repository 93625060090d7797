#include "host/commands/input_value.hpp"

#include "host/scene/value_reader.hpp"
#include "host/text/glyph.hpp"

#include <charconv>

namespace kfast {

std::optional<std::int32_t> read_input_value(std::string_view text, const InputView& input)
{
    const std::string_view number = text.substr(text.starts_with('+') ? 1 : 0);
    double value = 0;
    const auto [rest, error] = std::from_chars(number.data(), number.data() + number.size(), value);
    const bool is_whole = error == std::errc{} && rest == number.data() + number.size();
    if (!is_whole || !(value >= input.least / 1000.0 && value <= input.most / 1000.0))
        return std::nullopt;
    return scene::thousandths(value);
}

std::string input_value_mistake(std::string_view text, const InputView& input)
{
    return "'" + visible(text) + "' is no value of " + visible(input.name) + ": it goes from " +
           scene::text_of(input.least / 1000.0) + " to " + scene::text_of(input.most / 1000.0);
}

}

#include "host/commands/text/brightness_text.hpp"

#include "host/text/glyph.hpp"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <string_view>

namespace kfast {

std::uint8_t read_brightness(const std::string& option, const std::string& text)
{
    constexpr double brightest = 255;
    double number = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number, std::chars_format::fixed);
    const bool is_share = std::string_view{rest, end} == "%";
    const double max = is_share ? 100 : brightest;
    if (error != std::errc{} || !(is_share || rest == end) || !(number >= 0 && number <= max))
        throw CLI::ValidationError(option, "'" + visible(text) +
                                               "' is no brightness: write 0 to 255, or a share like 40%");
    return static_cast<std::uint8_t>(std::lround(number * brightest / max));
}

}

#include "host/fit/display.hpp"

#include "host/text/suggestion.hpp"

#include <algorithm>
#include <array>

namespace kfast::fit {
namespace {

/// Column and row with two words each, and the command to write: the controllers that follow MIPI DCS.
constexpr std::size_t dcs_window = 5 + 5 + 1;
/// Column and row with two bytes each.
constexpr std::size_t short_window = 3 + 3;

/// Sizes are those of the usual glass. Clocks are the write cycles of the makers' tables; a glass that has
/// run faster on somebody's desk is not rated for it. The byte order of colours is that of an 8-bit bus.
constexpr std::array displays{
    Display{"gc9a01", {240, 240}, PixelFormat::rgb565, {1, 1}, dcs_window, 0},
    Display{"ili9341", {240, 320}, PixelFormat::rgb565, {1, 1}, dcs_window, 10e6},
    Display{"ssd0323", {128, 64}, PixelFormat::grey4, {2, 1}, short_window, 4e6},
    Display{"ssd1306", {128, 64}, PixelFormat::mono1, {8, 8}, short_window, 10e6},
    Display{"ssd1322", {256, 64}, PixelFormat::grey4, {4, 1}, short_window + 1, 10e6},
    Display{"ssd1351", {128, 128}, PixelFormat::rgb565, {1, 1}, short_window + 1, 20e6},
    Display{"st7735", {128, 160}, PixelFormat::rgb565, {1, 1}, dcs_window, 15.15e6},
    Display{"st7789", {240, 240}, PixelFormat::rgb565, {1, 1}, dcs_window, 62.5e6},
    Display{"st7796", {320, 480}, PixelFormat::rgb565, {1, 1}, dcs_window, 62.5e6},
};

}

const Display* display_named(std::string_view name)
{
    const auto display = std::ranges::find(displays, name, &Display::name);
    return display == displays.end() ? nullptr : &*display;
}

std::string display_suggestion(std::string_view name)
{
    std::array<std::string_view, displays.size()> known;
    std::ranges::transform(displays, known.begin(), &Display::name);
    return suggestion(name, known);
}

}

#include "host/fit/display.hpp"

#include "firmware/settings/controller_facts.hpp"
#include "host/text/suggestion.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace kfast::fit {
namespace {

/// Column and row with two bytes each.
constexpr std::size_t short_window = 3 + 3;

constexpr Display default_display(Controller controller)
{
    const ControllerFacts& facts = facts_of(controller);
    return {.name = controller_names[static_cast<std::size_t>(controller)],
            .size = facts.default_value.glass,
            .format = facts.format,
            .granularity = facts.granularity,
            .window_bytes = static_cast<std::size_t>(facts.window_bytes),
            .rated_spi = static_cast<double>(facts.spi_hz)};
}

/// Its clock is not known from the maker (firmware/settings/controller_facts.hpp).
constexpr Display unrated(Display display)
{
    display.rated_spi = 0;
    return display;
}

/// Sizes are those of the most common glass. The byte order of colours is that of an 8-bit bus. For those
/// without a driver in firmware/panel/, clocks are the write cycles of the makers' tables too.
constexpr std::array known_displays{
    unrated(default_display(Controller::gc9a01)),
    default_display(Controller::ili9341),
    default_display(Controller::ssd0323),
    default_display(Controller::ssd1306),
    Display{"ssd1322", {256, 64}, PixelFormat::grey4, {4, 1}, short_window + 1, 10e6, false},
    default_display(Controller::ssd1351),
    default_display(Controller::st7735),
    default_display(Controller::st7789),
    Display{"st7796", {320, 480}, PixelFormat::rgb565, {1, 1}, dcs_window_bytes, 62.5e6, false},
};

}

Display taking(PixelFormat format, Display display)
{
    display.format = format;
    display.granularity.width = std::lcm(display.granularity.width, pixels_in_whole_bytes(format));
    return display;
}

const Display* display_named(std::string_view name)
{
    const auto display = std::ranges::find(known_displays, name, &Display::name);
    return display == known_displays.end() ? nullptr : &*display;
}

const Display* display_like(PixelFormat format)
{
    const auto display = std::ranges::find_if(known_displays, [format](const Display& known) {
        return bits_per_pixel(known.format) == bits_per_pixel(format);
    });
    return display == known_displays.end() ? nullptr : &*display;
}

std::span<const Display> displays() { return known_displays; }

std::vector<std::string_view> display_names()
{
    std::vector<std::string_view> names(known_displays.size());
    std::ranges::transform(known_displays, names.begin(), &Display::name);
    return names;
}

std::string display_suggestion(std::string_view name) { return suggestion(name, display_names()); }

}

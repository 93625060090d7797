#include "host/fit/display.hpp"
#include "host/fit/other_name.hpp"
#include "host/picture/format_name.hpp"

namespace kfast::fit {
namespace {

// How the sentence goes on that begins with what it is.
constexpr std::string_view pages = "takes pages of 8 rows, no rectangles: take one with an SSD1306";
constexpr std::string_view not_yet =
    "has no driver yet; for an estimate describe it with the board, as panel 320 240 format=rgb565";

constexpr std::array panels{
    OtherName{"sh1106 sh1107 sh1108", "an SH1106, often sold as an SSD1306 of 1.3 inches,", pages},
    OtherName{"st7565 uc1701 pcd8544 nokia5110 ks0108", "this controller", pages},
    OtherName{"st7920", "an ST7920",
              "takes rows in words of 16 pixels, and has no driver: take one with an SSD1306"},
    OtherName{"ssd1309 ssd1305", "this controller",
              "has the commands of the SSD1306 for pictures: try ssd1306, which nobody has done yet"},
    OtherName{"epaper eink epd waveshareepaper ssd1680 ssd1681 ssd1675 uc8151 il0373 gdew", "e-paper",
              "takes a second or more for a picture, too long for animations"},
    OtherName{"ssd1331 ili9163 ili9225 ili9481 hx8357 hx8347 ra8875 ssd1963 gc9107 gc9d01", "this controller",
              not_yet},
    OtherName{"ili9486 ili9488", "an ILI9488",
              "has no driver yet, and takes 18 bits for a pixel by SPI; for an estimate describe it with the "
              "board, as "
              "panel 320 480 format=rgb666"},
    OtherName{"st7789v st7789v2 st7789vw st7789s", "an ST7789V", "is an ST7789: take st7789"},
    OtherName{"st7735s st7735r st7735b", "an ST7735S", "is an ST7735: take st7735"},
    OtherName{"ili9342 ili9342c ili9340", "an ILI9342", "has the commands of the ILI9341: try ili9341"},
    OtherName{"gc9a01a gc9a01n", "a GC9A01A", "is a GC9A01: take gc9a01"},
    OtherName{"oled oled128x64 ssd1306i2c ssd1306spi", "the OLED that most people have",
              "has an SSD1306: take ssd1306"},
    OtherName{"hub75 ws2812 ws2812b neopixel max7219 apa102", "a matrix of lights", "has no driver"},
    OtherName{"hd44780 lcd1602 lcd2004 lcd", "a display of letters", "shows no pictures"},
};

}

std::span<const OtherName> other_panels() { return panels; }

std::optional<std::string> other_panel_text(std::string_view name)
{
    const auto* const panel =
        std::ranges::find_if(panels, [name](const OtherName& other) { return is_called(other, name); });
    if (panel == panels.end())
        return std::nullopt;
    return std::string{panel->what} + ' ' + std::string{panel->hint};
}

std::optional<std::string> undriven_panel_text(std::string_view name)
{
    const Display* const display = display_named(name);
    if (display == nullptr)
        return other_panel_text(name);
    if (display->is_driven)
        return std::nullopt;
    return "kfast fit alone knows it, for it has no driver yet; its picture is that of --size " +
           std::to_string(display->size.width) + 'x' + std::to_string(display->size.height) + " --format " +
           std::string{name_of(display->format)};
}

}

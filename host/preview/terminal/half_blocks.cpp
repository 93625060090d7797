#include "host/preview/terminal/half_blocks.hpp"

#include "core/pixel/paint_style.hpp"
#include "host/preview/painter/scaled_picture.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>

namespace kfast {

namespace {

constexpr std::array with_16{"linux", "ansi", "cygwin", "cons25", "pcansi"};

std::string_view word(const char* text) { return text == nullptr ? "" : text; }

}

TerminalColours terminal_colours(const char* colorterm, const char* term, const char* no_color)
{
    const std::string_view says = word(colorterm);
    const std::string_view type = word(term);
    if (!word(no_color).empty() || type == "dumb")
        return TerminalColours::none;
    if (says == "truecolor" || says == "24bit" || type.ends_with("-direct"))
        return TerminalColours::true_colour;
    if (type.starts_with("vt"))
        return TerminalColours::none;
    if (std::ranges::any_of(with_16, [type](const char* name) { return type == name; }) ||
        type.ends_with("-16color"))
        return TerminalColours::palette_16;
    return TerminalColours::palette_256;
}

TerminalColours terminal_colours()
{
    return terminal_colours(std::getenv("COLORTERM"), std::getenv("TERM"), std::getenv("NO_COLOR"));
}

namespace {

constexpr int above = 38;
constexpr int below = 48;

Picture shrunk(const Picture& picture, Size space)
{
    if (picture.size.width <= space.width && picture.size.height <= space.height)
        return picture;
    const Rect place = placement(picture.size, space);
    Picture small{{place.width, place.height}, {}};
    const ScaledPicture scaled{picture, {0, 0, place.width, place.height}};
    for (int y = 0; y < small.size.height; ++y)
        for (int x = 0; x < small.size.width; ++x)
            small.pixels.push_back(scaled.at(x, y));
    return small;
}

// xterm's palette: a cube of 6 x 6 x 6 from number 16 on, then 24 greys from 8 in steps of 10.
constexpr std::array<int, 6> cube_levels{0, 95, 135, 175, 215, 255};

int cube_index(int value) { return value < 48 ? 0 : value < 115 ? 1 : (value - 35) / 40; }

int distance(Colour colour, int red, int green, int blue)
{
    return std::abs(colour.red - red) + std::abs(colour.green - green) + std::abs(colour.blue - blue);
}

int palette_number(Colour colour)
{
    const int red = cube_index(colour.red);
    const int green = cube_index(colour.green);
    const int blue = cube_index(colour.blue);
    const int mean = (colour.red + colour.green + colour.blue) / 3;
    const int step = mean < 3 ? 0 : std::min((mean - 3) / 10, 23);
    const int grey = 8 + 10 * step;
    const auto level = [](int index) { return cube_levels[static_cast<std::size_t>(index)]; };
    const bool grey_is_nearer =
        distance(colour, grey, grey, grey) < distance(colour, level(red), level(green), level(blue));
    return grey_is_nearer ? 232 + step : 16 + 36 * red + 6 * green + blue;
}

/// The nearest of the 16 colours, as xterm has them.
int number_of_16(Colour colour)
{
    constexpr std::array<Colour, 16> known{{{0, 0, 0},
                                            {205, 0, 0},
                                            {0, 205, 0},
                                            {205, 205, 0},
                                            {0, 0, 238},
                                            {205, 0, 205},
                                            {0, 205, 205},
                                            {229, 229, 229},
                                            {127, 127, 127},
                                            {255, 0, 0},
                                            {0, 255, 0},
                                            {255, 255, 0},
                                            {92, 92, 255},
                                            {255, 0, 255},
                                            {0, 255, 255},
                                            {255, 255, 255}}};
    const auto* const nearest = std::ranges::min_element(
        known, {}, [colour](Colour one) { return distance(colour, one.red, one.green, one.blue); });
    return static_cast<int>(nearest - known.begin());
}

std::string colour_code(int ground, Colour colour, TerminalColours colours)
{
    if (colours == TerminalColours::palette_16) {
        constexpr int bright = 60 - 8; // 90 ... 97 and 100 ... 107 are the bright ones of 30 ... and 40 ...
        const int number = number_of_16(colour);
        return "\x1b[" + std::to_string(ground - 8 + number + (number < 8 ? 0 : bright)) + 'm';
    }
    std::string code = "\x1b[" + std::to_string(ground);
    if (colours == TerminalColours::palette_256)
        return code + ";5;" + std::to_string(palette_number(colour)) + 'm';
    for (const int value : {2, +colour.red, +colour.green, +colour.blue})
        code += ';' + std::to_string(value);
    return code + 'm';
}

/// The background or foreground of a line, which writes its colour only where it changes.
class Ground {
public:
    Ground(int number, TerminalColours colours) : number_{number}, colours_{colours} {}

    std::string change_to(Colour colour)
    {
        if (is_set_ && last_ == colour)
            return {};
        is_set_ = true;
        last_ = colour;
        return colour_code(number_, colour, colours_);
    }

private:
    int number_;
    TerminalColours colours_;
    bool is_set_ = false;
    Colour last_;
};

std::string line_without_colours(const Picture& picture, int y)
{
    constexpr std::string_view by_brightness = " .:-=+*#%@";
    std::string text;
    for (int x = 0; x < picture.size.width; ++x) {
        const std::uint32_t upper = brightness(picture.at(x, y));
        const std::uint32_t lower = y + 1 < picture.size.height ? brightness(picture.at(x, y + 1)) : 0;
        text += by_brightness[(upper + lower) * by_brightness.size() / 512];
    }
    return text + '\n';
}

std::string line(const Picture& picture, int y, TerminalColours colours)
{
    if (colours == TerminalColours::none)
        return line_without_colours(picture, y);
    std::string text;
    Ground upper{above, colours};
    Ground lower{below, colours};
    for (int x = 0; x < picture.size.width; ++x) {
        text += upper.change_to(picture.at(x, y));
        if (y + 1 < picture.size.height)
            text += lower.change_to(picture.at(x, y + 1));
        text += "\u2580";
    }
    return text + "\x1b[0m\n";
}

}

std::string half_blocks(const Picture& picture, Size cells, TerminalColours colours)
{
    const Picture small = shrunk(picture, {cells.width, cells.height * 2});
    std::string text;
    for (int y = 0; y < small.size.height; y += 2)
        text += line(small, y, colours);
    return text;
}

}

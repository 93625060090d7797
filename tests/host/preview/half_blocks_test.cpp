#include "host/preview/terminal/half_blocks.hpp"

#include <doctest/doctest.h>

#include <regex>

namespace kfast::test {
namespace {

constexpr Colour black{};
constexpr Colour red{255, 0, 0};
constexpr Colour white{255, 255, 255};

std::string without_colours(const std::string& text)
{
    return std::regex_replace(text, std::regex{"\x1b\\[[0-9;]*m"}, "");
}

std::string blocks(int count)
{
    std::string text;
    for (int i = 0; i < count; ++i)
        text += "\u2580";
    return text;
}

}

TEST_CASE("each character is two pixels in true colour; colours are said where they change")
{
    const Picture picture{{3, 2}, {red, red, black, white, black, black}};
    CHECK(half_blocks(picture, {80, 24}, TerminalColours::true_colour) ==
          "\x1b[38;2;255;0;0m\x1b[48;2;255;255;255m\u2580\x1b[48;2;0;0;0m\u2580\x1b[38;2;0;0;0m\u2580\x1b["
          "0m\n");
}

TEST_CASE("256 colours take the nearest of cube and greys")
{
    const Picture picture{{2, 2}, {red, {128, 128, 128}, white, {95, 135, 215}}};
    CHECK(half_blocks(picture, {80, 24}, TerminalColours::palette_256) ==
          "\x1b[38;5;196m\x1b[48;5;231m\u2580\x1b[38;5;244m\x1b[48;5;68m\u2580\x1b[0m\n");
}

TEST_CASE("16 colours take the nearest, dark ones and bright ones")
{
    const Picture picture{{2, 2}, {red, {200, 0, 10}, white, {0, 0, 0}}};
    CHECK(half_blocks(picture, {80, 24}, TerminalColours::palette_16) ==
          "\x1b[91m\x1b[107m\u2580\x1b[31m\x1b[40m\u2580\x1b[0m\n");
}

TEST_CASE("without colours characters are as bright as the pixels")
{
    const Picture picture{{3, 2}, {black, white, white, black, black, white}};
    CHECK(half_blocks(picture, {80, 24}, TerminalColours::none) == " =@\n");
}

TEST_CASE("the last line of an odd picture has no lower half")
{
    const Picture picture{{1, 1}, {red}};
    CHECK(half_blocks(picture, {80, 24}, TerminalColours::true_colour) ==
          "\x1b[38;2;255;0;0m\u2580\x1b[0m\n");
}

TEST_CASE("a large picture is shrunk to the terminal, a small one keeps its size")
{
    const Picture large{{200, 100}, std::vector<Colour>(20000, red)};
    const std::string line = blocks(40) + '\n';
    std::string ten_lines;
    for (int i = 0; i < 10; ++i)
        ten_lines += line;
    CHECK(without_colours(half_blocks(large, {40, 20}, TerminalColours::true_colour)) == ten_lines);
    const Picture small{{4, 2}, std::vector<Colour>(8, red)};
    CHECK(without_colours(half_blocks(small, {40, 20}, TerminalColours::true_colour)) == blocks(4) + '\n');
}

TEST_CASE("shrinking takes the mean")
{
    const Picture picture{{2, 4}, {black, white, black, white, black, black, black, black}};
    CHECK(half_blocks(picture, {1, 1}, TerminalColours::true_colour) ==
          "\x1b[38;2;128;128;128m\x1b[48;2;0;0;0m\u2580\x1b[0m\n");
}

}

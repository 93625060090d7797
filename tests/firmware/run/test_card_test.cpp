#include "firmware/run/test_card.hpp"

#include "tests/firmware/run/drawn_card.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

constexpr BoardNames names{"pico spi", "st7789"};

}

TEST_CASE("a test card frames the panel at its very border")
{
    for (const Size panel : {Size{128, 64}, Size{240, 240}, Size{80, 160}, Size{6, 4}}) {
        const auto rows = drawn<PixelFormat::rgb565>(TestCard{names, panel}, panel);
        const std::string full(static_cast<std::size_t>(panel.width), '#');
        CHECK(rows.front() == full);
        CHECK(rows.back() == full);
        for (const std::string& row : rows) {
            CHECK(row.front() == '#');
            CHECK(row.back() == '#');
        }
    }
}

TEST_CASE("a test card has red, green and blue from left to right, with their letters")
{
    const auto rows = drawn<PixelFormat::rgb565>(TestCard{names, {240, 240}}, {240, 240});
    // lines of 4 x 6 rows from row 24 on; the bars are the sixth and seventh
    const std::string& blank = rows[24 + 5 * 24 + 4];
    CHECK(blank == '#' + std::string(29, '.') + std::string(60, 'r') + std::string(60, 'g') +
                       std::string(60, 'b') + std::string(29, '.') + '#');
    const std::string& middle = rows[24 + 5 * 24 + 20]; // where both letters are ##.
    CHECK(middle.substr(30 + 24, 12) == "........rrrr");
    CHECK(middle.substr(150 + 24, 12) == "........bbbb");
}

TEST_CASE(
    "a test card tells which side is up, the board, the panel, its size and the version, and why it is shown")
{
    Card expected{{240, 240}};
    expected.add("^ top ^", 4, 24);
    expected.add("pico spi", 4, 48);
    expected.add("st7789", 4, 72);
    expected.add("240x240", 4, 96);
    expected.add(version_line, 4, 120);
    expected.add("no scene", 4, 192);
    const auto rows = drawn<PixelFormat::rgb565>(TestCard{names, {240, 240}}, {240, 240});
    const auto lines = drawn<PixelFormat::rgb565>(expected, {240, 240});
    for (std::size_t y = 1; y < 239; ++y)
        if (y < 144 || y >= 192) // without the bars
            CHECK(rows[y].substr(1, 238) == lines[y].substr(1, 238));
}

}

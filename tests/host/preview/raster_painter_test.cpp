#include "host/preview/painter/raster_painter.hpp"

#include <array>
#include <cstddef>
#include <doctest/doctest.h>
#include <string>

namespace kfast::test {
namespace {

constexpr Colour white{255, 255, 255};
constexpr Colour red{255, 0, 0};

/// Pixels of the left upper corner: '#' where it is more white than not.
std::string row_of(const Picture& picture, int y)
{
    std::string row;
    for (int x = 0; x < picture.size.width; ++x)
        row += picture.at(x, y).red > 127 ? '#' : '.';
    return row;
}

}

TEST_CASE("areas are filled within the window and the clip")
{
    RasterPainter painter;
    painter.begin({6, 3});
    painter.clip(Rect{1, 0, 3, 2});
    painter.fill({-5, 1, 100, 100}, white);
    CHECK(row_of(painter.drawn(), 0) == "......");
    CHECK(row_of(painter.drawn(), 1) == ".###..");
    CHECK(row_of(painter.drawn(), 2) == "......");
    painter.clip(std::nullopt);
    painter.fill({5, 2, 9, 9}, white);
    CHECK(row_of(painter.drawn(), 2) == ".....#");
}

TEST_CASE("what is not opaque lets shine through")
{
    RasterPainter painter;
    painter.begin({1, 1});
    painter.fill({0, 0, 1, 1}, {200, 100, 0, 128});
    CHECK(painter.drawn().at(0, 0) == Colour{100, 50, 0});
    painter.fill({0, 0, 1, 1}, {0, 0, 0, 0});
    CHECK(painter.drawn().at(0, 0) == Colour{100, 50, 0});
}

TEST_CASE("polygons cover shares of pixels")
{
    RasterPainter painter;
    painter.begin({4, 3});
    painter.polygon(std::array{WindowSpot{0.5, 1}, WindowSpot{3, 1}, WindowSpot{3, 2}, WindowSpot{0.5, 2}},
                    white);
    CHECK(row_of(painter.drawn(), 0) == "....");
    CHECK(painter.drawn().at(0, 1).red == doctest::Approx(128).epsilon(0.01));
    CHECK(painter.drawn().at(1, 1) == white);
    CHECK(painter.drawn().at(2, 1) == white);
    CHECK(painter.drawn().at(3, 1).red == 0);
    CHECK(row_of(painter.drawn(), 2) == "....");
}

TEST_CASE("polygons stay within the clip, however far they reach")
{
    RasterPainter painter;
    painter.begin({4, 2});
    painter.clip(Rect{1, 0, 2, 1});
    painter.polygon(std::array{WindowSpot{-1e9, -1e9}, WindowSpot{1e9, -1e9}, WindowSpot{1e9, 1e9},
                               WindowSpot{-1e9, 1e9}},
                    white);
    CHECK(row_of(painter.drawn(), 0) == ".##.");
    CHECK(row_of(painter.drawn(), 1) == "....");
}

TEST_CASE("letters stay within their cells, also those with accents and those the font does not have")
{
    constexpr Size letter = Painter::letter;
    RasterPainter painter;
    for (const char* text : {"W", "g", "É", "|", "…", "\xFF", "\xE2\x98\x83", "\xF4\x8F\xBF\xBD"}) {
        painter.begin({3 * letter.width, 3 * letter.height});
        painter.text(letter.width, letter.height, text, white);
        bool any = false;
        for (int y = 0; y < 3 * letter.height; ++y)
            for (int x = 0; x < 3 * letter.width; ++x) {
                const bool is_lit = painter.drawn().at(x, y).red > 0;
                const bool is_in_cell =
                    x >= letter.width && x < 2 * letter.width && y >= letter.height && y < 2 * letter.height;
                CHECK((!is_lit || is_in_cell));
                any = any || is_lit;
            }
        CHECK_MESSAGE(any, text);
    }
}

TEST_CASE("pictures are enlarged with hard pixels and shrunk to their mean")
{
    const Picture picture{{2, 2}, {white, {}, red, white}};
    RasterPainter painter;
    painter.begin({6, 4});
    painter.picture(picture, {1, 0, 4, 4});
    CHECK(row_of(painter.drawn(), 0) == ".##...");
    CHECK(row_of(painter.drawn(), 3) == ".####.");
    CHECK(painter.drawn().at(2, 2) == red);
    painter.picture(picture, {0, 0, 1, 1});
    CHECK(painter.drawn().at(0, 0) == Colour{191, 128, 128});
}

TEST_CASE("a picture larger than the window is seen in part")
{
    const Picture picture{{2, 1}, {white, {}}};
    RasterPainter painter;
    painter.begin({4, 2});
    painter.picture(picture, {-3, -10, 8, 40});
    CHECK(row_of(painter.drawn(), 0) == "#...");
    CHECK(row_of(painter.drawn(), 1) == "#...");
}

}

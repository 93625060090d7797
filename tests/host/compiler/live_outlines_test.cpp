#include "core/player.hpp"
#include "host/player/received_drawing.hpp"
#include "tests/core/player_fixture.hpp"
#include "tests/rounds.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <random>
#include <string>

/// The bound on the outlines of drawings that are told from outside.
namespace kfast::test {
namespace {

constexpr Size canvas{120, 90};
constexpr std::size_t max_points = 60;
constexpr std::size_t max_strokes = 6;

struct DrawingGenerator {
    std::mt19937 random;

    explicit DrawingGenerator(unsigned seed) : random{seed} {}

    std::int16_t any(int low, int high)
    {
        return static_cast<std::int16_t>(low +
                                         static_cast<int>(random() % static_cast<unsigned>(high - low + 1)));
    }

    /// The n-th point of something that is as bad as possible in its own way.
    InputPoint point(int kind, int n)
    {
        const auto odd = static_cast<std::int16_t>(n % 2);
        switch (kind) {
        case 0: // up and down
            return {static_cast<std::int16_t>(16 * n), static_cast<std::int16_t>(odd * 1000)};
        case 1: // anywhere
            return {any(-32768, 32767), any(-32768, 32767)};
        case 2: // there and back
            return {static_cast<std::int16_t>(odd * 1000), static_cast<std::int16_t>(odd * 700)};
        case 3: // nearly level
            return {static_cast<std::int16_t>(12 * n), any(500, 501)};
        case 4: // shorter than the pen is wide
            return {any(600, 640), any(600, 640)};
        case 5: // level, back and forth
            return {static_cast<std::int16_t>(odd * 1500 + n), any(500, 502)};
        case 6: // a spiral
            return {static_cast<std::int16_t>(900 + 10 * n * std::cos(n * 2.4)),
                    static_cast<std::int16_t>(700 + 10 * n * std::sin(n * 2.4))};
        default: // slight bends
            return {static_cast<std::int16_t>(900 + 500 * std::cos(n * 0.1)),
                    static_cast<std::int16_t>(700 + 500 * std::sin(n * 0.1))};
        }
    }

    ReceivedDrawing drawing(int kind)
    {
        ReceivedDrawing result(random() % 3 == 0 ? max_strokes : 1);
        for (std::size_t n = 0; n < max_points; ++n)
            result[n * result.size() / max_points].push_back(point(kind, static_cast<int>(n)));
        if (random() % 2 == 0)
            for (auto& stroke : result)
                stroke.back() = stroke.front();
        return result;
    }
};

std::string scene(const std::string& style)
{
    return "kfast 1\ncanvas 120 90\ninput i kind=drawing points=60 strokes=6\nobject o live=i " + style;
}

}

TEST_CASE("whatever is told finds room as finely as it is wanted, at any pen, place and turn")
{
    std::size_t fullest = 0;
    for (const std::string style :
         {"fill=red", "fill=red rotate=33", "stroke=red width=0.1", "stroke=red width=2",
          "stroke=red width=40", "stroke=red width=3 join=bevel cap=round",
          "stroke=red width=12 join=round cap=round", "stroke=red width=1 join=round cap=square",
          "stroke=red width=200 join=round cap=round",
          "fill=red stroke=red width=7 miter=31 scale=3 rotate=77",
          "stroke=red width=5 join=round rotate-y=70",
          "stroke=red width=2 join=round cap=round rotate-x=80 z=100"}) {
        CAPTURE(style);
        PlayerFixture fixture{scene(style), canvas};
        DrawingGenerator generator{1};
        for (int round = 0; round < 200; ++round) {
            const int kind = round % 8;
            CAPTURE(kind);
            CHECK(fixture.player.set_drawing(0, strokes_of(generator.drawing(kind))));
            fixture.player.show({});
            const raster::Picture& picture = fixture.player.picture();
            REQUIRE_FALSE(picture.outlines.is_full());
            REQUIRE(picture.coarseness == 0);
            fullest =
                std::max(fullest, 100 * picture.outlines.needed_bytes() / fixture.scene.outline_bytes());
        }
    }
    CHECK(fullest > 55); // else the bound would be far too high
}

TEST_CASE("what is not seen, and uses of symbols, count in the bound")
{
    const auto bytes = [](const std::string& items) {
        return PlayerFixture{"kfast 1\ncanvas 120 90\ninput i kind=drawing points=60\n" + items, canvas}
            .scene.outline_bytes();
    };
    const std::size_t once = bytes("object o live=i stroke=red");
    CHECK(bytes("symbol s { object o live=i stroke=red }\nuse s; use s y=3; use s y=9") > 2 * once);
    CHECK(bytes("object o live=i stroke=red visible=#false\nobject p fill=red { rect 0 0 2 2 }") < once / 10);
    CHECK(bytes("object o live=i stroke=red { key 0 visible=#false; key 9 visible=#true }") == once);
}

}

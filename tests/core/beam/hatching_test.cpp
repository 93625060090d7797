#include "core/beam/hatching.hpp"
#include "tests/core/beam/beam_player_fixture.hpp"
#include "tests/rounds.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

namespace kfast::test {
namespace {

/// The pieces of a hatching.
struct PieceList {
    struct Piece {
        Point from;
        Point to;
    };
    std::vector<Piece> pieces = {};

    void begin(Point) {}
    void add(const Segment& segment) { pieces.push_back({segment.from, segment.to}); }
    void end(Point, bool) {}
};

using Polygon = std::vector<Point>;

double pixels(Fixed value) { return value.raw() / 65536.0; }

void feed(const std::vector<Polygon>& polygons, Hatching& hatching)
{
    for (const Polygon& polygon : polygons) {
        hatching.begin(polygon.front());
        for (std::size_t i = 1; i < polygon.size(); ++i)
            hatching.add({.from = polygon[i - 1], .to = polygon[i]});
        hatching.end(polygon.front(), false);
    }
}

PieceList hatched(const std::vector<Polygon>& polygons, const BeamStyle& style, FillRule rule)
{
    std::vector<std::uint32_t> memory(1 << 16);
    Hatching hatching{std::as_writable_bytes(std::span{memory}), style, 0, 0};
    feed(polygons, hatching);
    REQUIRE(!hatching.is_full());
    PieceList list;
    hatching.trace(rule, {}, list);
    return list;
}

/// How often the polygons go round a place, by the crossings of a line to the right of it.
int winding_at(const std::vector<Polygon>& polygons, double x, double y)
{
    int winding = 0;
    for (const Polygon& polygon : polygons)
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Point a = polygon[i];
            const Point b = polygon[(i + 1) % polygon.size()];
            if ((pixels(a.y) <= y) == (pixels(b.y) <= y))
                continue;
            const double share = (y - pixels(a.y)) / (pixels(b.y) - pixels(a.y));
            if (pixels(a.x) + share * (pixels(b.x) - pixels(a.x)) > x)
                winding += pixels(b.y) > pixels(a.y) ? 1 : -1;
        }
    return winding;
}

std::vector<Polygon> random_polygons(std::mt19937& random)
{
    std::vector<Polygon> polygons(1 + random() % 3);
    for (Polygon& polygon : polygons) {
        polygon.resize(3 + random() % 6);
        for (Point& point : polygon)
            point = {Fixed::sixteenths(static_cast<std::int32_t>(random() % 4000) - 2000),
                     Fixed::sixteenths(static_cast<std::int32_t>(random() % 4000) - 2000)};
    }
    return polygons;
}

/// The length of all pieces, in pixels.
double length_of(const PieceList& list)
{
    double length = 0;
    for (const auto& [from, to] : list.pieces)
        length += std::hypot(pixels(to.x - from.x), pixels(to.y - from.y));
    return length;
}

/// The area inside, looked at in the middle of every square of half a pixel.
double area_of(const std::vector<Polygon>& polygons, FillRule rule)
{
    constexpr int reach = 252;
    double area = 0;
    for (int y = -reach; y < reach; ++y)
        for (int x = -reach; x < reach; ++x)
            area += is_inside(rule, winding_at(polygons, x / 2.0 + 0.26, y / 2.0 + 0.26)) ? 0.25 : 0;
    return area;
}

BeamPlayerFixture hatched_square(const std::string& properties)
{
    return BeamPlayerFixture{"kfast 1\ncanvas 256 256\nobject o fill=white " + properties +
                             " { rect 20 20 100 100 }"};
}

}

TEST_CASE("a square is crossed by lines half a spacing from its edges, if these begin at a whole one")
{
    BeamPlayerFixture fixture = hatched_square("beam=hatch hatch=10 hatch-angle=0");
    CHECK(fixture.player.report().lines == 10);
    CHECK(fixture.player.report().lit_length == 10 * 100 * 256);
    CHECK(fixture.player.report().wider_hatchings == 0);
    CHECK_FALSE(fixture.player.is_coarse());
    // from each line to the next at the same side, and the way back
    CHECK(fixture.player.report().blanked_length <= (9 + 9 + 100) * 10 * 256);
}

TEST_CASE("an object is drawn as it says")
{
    CHECK(hatched_square("").player.report().lines == 1);
    CHECK(hatched_square("beam=outline").player.report().lit_length == 4 * 100 * 256);
    CHECK(hatched_square("beam=none").player.report().lines == 0);
    CHECK(hatched_square("beam=both hatch=20 hatch-angle=90").player.report().lines == 6);
}

TEST_CASE("holes stay free by the rule of the fill")
{
    const auto ring = [](const std::string& rule) {
        return BeamPlayerFixture{
            "kfast 1\ncanvas 256 256\nobject o fill=white beam=hatch hatch=10 hatch-angle=0 rule=" + rule +
            " { rect 0 0 200 200; rect 50 50 100 100 }"}
            .player.report()
            .lit_length;
    };
    CHECK(ring("nonzero") == 20 * 200 * 256);
    CHECK(ring("even-odd") == (20 * 200 - 10 * 100) * 256);
}

TEST_CASE(
    "the pieces of a hatching lie inside, and together they are as long as the area divided by the spacing")
{
    std::mt19937 random{5};
    for (int i = 0; i < rounds(20); ++i) {
        const auto polygons = random_polygons(random);
        const BeamStyle style{.parts = BeamParts::hatch,
                              .spacing = 16,
                              .direction =
                                  BinaryAngle::from_raw(static_cast<std::int32_t>(random() % 65536))};
        for (const FillRule rule : {FillRule::nonzero, FillRule::even_odd}) {
            const PieceList list = hatched(polygons, style, rule);
            int outside = 0;
            for (const auto& [from, to] : list.pieces) {
                const double width = pixels(to.x - from.x);
                const double height = pixels(to.y - from.y);
                if (std::hypot(width, height) < 1.0 / 16)
                    continue; // may be what rounding has left of none
                for (const double share : {0.02, 0.5, 0.98}) {
                    const int winding =
                        winding_at(polygons, pixels(from.x) + share * width, pixels(from.y) + share * height);
                    outside += is_inside(rule, winding) ? 0 : 1;
                }
            }
            CHECK(outside == 0);
            const double area = area_of(polygons, rule);
            CHECK(std::abs(length_of(list) - area) < 0.02 * area + 60);
        }
    }
}

TEST_CASE("a corner that lies on a line of the hatching is no dot")
{
    const auto corner = [](int x, int y) { return Point{Fixed::pixels(x), Fixed::pixels(y)}; };
    const BeamStyle style{.parts = BeamParts::hatch, .spacing = 64}; // lines at 2, 6, 10 … pixels
    CHECK(
        hatched({{corner(50, 10), corner(80, 60), corner(20, 60)}}, style, FillRule::nonzero).pieces.size() ==
        12);
    CHECK(
        hatched({{corner(50, 11), corner(80, 60), corner(20, 60)}}, style, FillRule::nonzero).pieces.size() ==
        12);
}

TEST_CASE("neighbouring lines of a hatching run in opposite directions")
{
    const Polygon square{
        {}, {Fixed::pixels(64), {}}, {Fixed::pixels(64), Fixed::pixels(64)}, {{}, Fixed::pixels(64)}};
    const PieceList list = hatched({square}, {.parts = BeamParts::hatch, .spacing = 64}, FillRule::nonzero);
    REQUIRE(list.pieces.size() == 16);
    for (std::size_t i = 0; i < list.pieces.size(); ++i) {
        CHECK((list.pieces[i].to.x > list.pieces[i].from.x) == (i % 2 == 0));
        CHECK(list.pieces[i].from.y == Fixed::pixels(static_cast<std::int32_t>(4 * i + 2)));
    }
}

TEST_CASE("a hatching that finds no room says so")
{
    const Polygon square{
        {}, {Fixed::pixels(64), {}}, {Fixed::pixels(64), Fixed::pixels(64)}, {{}, Fixed::pixels(64)}};
    std::array<std::uint32_t, 28> memory; // 112 bytes: 14 for a crossing
    const auto is_full = [&](int wider) {
        Hatching hatching{std::as_writable_bytes(std::span{memory}), {.spacing = 64}, wider, 0};
        feed({square}, hatching);
        return hatching.is_full();
    };
    CHECK(is_full(0));
    CHECK(is_full(1));
    CHECK(!is_full(2));
}

TEST_CASE("a hatching without room is wider, and the report tells of it")
{
    // Far larger than the canvas, which the memory goes by.
    BeamPlayerFixture fixture{R"(kfast 1
        canvas 64 64
        object o fill=white beam=hatch hatch=0.5 { polygon -1900 -1900 1900 -1900 1900 1900 -1900 1900 })"};
    CHECK(fixture.player.report().wider_hatchings == 1);
    CHECK(fixture.player.report().lines > 0);
    CHECK(fixture.player.is_coarse());
}

TEST_CASE("a hatching turns in space with its object")
{
    BeamPlayerFixture fixture{R"(kfast 1
        canvas 256 256
        object o fill=white beam=hatch hatch=16 hatch-angle=0 rotate-y=60 { rect 64 64 128 128 })"};
    CHECK(fixture.player.report().lines == 8);
    CHECK(fixture.player.report().lit_length < 8 * 128 * 256 * 6 / 10);
    CHECK(fixture.player.report().lit_length > 8 * 128 * 256 * 4 / 10);
}

}

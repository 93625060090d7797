#include "core/beam/beam_pen.hpp"
#include "tests/core/beam/line_store.hpp"
#include "tests/rounds.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace kfast::test {
namespace {

constexpr int resolution = 256;
constexpr std::int32_t units = field_side / resolution; ///< in a pixel
constexpr double half = field_side / 2.0;

/// In units of the field, as the field has them.
Point seen(double x, double y)
{
    const auto pixels = [](double value) {
        return Fixed::from_raw(static_cast<std::int32_t>(std::lround(value / units * Fixed::one)));
    };
    return {pixels(x + half), pixels(half - y)};
}

struct Stroke {
    std::vector<std::pair<double, double>> corners; ///< in units of the field
    bool is_closed = false;
};

void draw(const Stroke& stroke, BeamLines& lines, BeamInk ink = BeamInk::stroke, int coarseness = 0)
{
    BeamPen pen{lines, ViewProjection{nullptr, coarseness}, resolution, ink, {255, 255, 255, 255}, 0};
    const auto at = [&](std::size_t i) { return seen(stroke.corners[i].first, stroke.corners[i].second); };
    pen.begin(at(0));
    for (std::size_t i = 1; i < stroke.corners.size(); ++i)
        pen.add({.from = at(i - 1), .to = at(i)});
    pen.end(at(0), stroke.is_closed);
}

using Lines = std::vector<std::vector<FieldPoint>>;

Lines drawn(const Stroke& stroke, BeamInk ink = BeamInk::stroke)
{
    LineStore store;
    draw(stroke, store.lines, ink);
    Lines lines;
    for (std::size_t number = 0; number < store.lines.size(); ++number)
        lines.push_back(store.points(number));
    return lines;
}

/// The stretch of a piece that lies in the field, if any does; by Liang and Barsky's method.
std::optional<std::pair<double, double>> stretch_in_field(double x, double y, double to_x, double to_y)
{
    double begin = 0;
    double end = 1;
    for (const auto& [from, delta] : {std::pair{x, to_x - x}, std::pair{y, to_y - y}})
        for (const double side : {-half, half}) {
            const double room = side < 0 ? from - side : side - from;
            const double leaves = side < 0 ? -delta : delta;
            if (leaves == 0 && room < 0)
                return std::nullopt;
            if (leaves < 0)
                begin = std::max(begin, room / leaves);
            if (leaves > 0)
                end = std::min(end, room / leaves);
        }
    if (begin > end)
        return std::nullopt;
    return std::pair{begin, end};
}

double length(const Lines& lines)
{
    double sum = 0;
    for (const auto& line : lines)
        for (std::size_t i = 1; i < line.size(); ++i)
            sum += std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
    return sum;
}

}

TEST_CASE("lines that cross the border end on it, rounded to nearest")
{
    CHECK(drawn({{{0, 0}, {65536, 32768}}}) == Lines{{{0, 0}, {32767, 16384}}});
    CHECK(drawn({{{65536, 32768}, {0, 0}}}) == Lines{{{32767, 16384}, {0, 0}}});
    CHECK(drawn({{{-40000, 10}, {40000, 11}}}) == Lines{{{-32768, 10}, {32767, 11}}});
    CHECK(drawn({{{0, -60000}, {0, 60000}}}) == Lines{{{0, -32768}, {0, 32767}}});
}

TEST_CASE("a line that leaves the field and comes back becomes several")
{
    CHECK(drawn({{{0, 0}, {40000, 0}, {40000, 1000}, {0, 1000}}}) ==
          Lines{{{0, 0}, {32767, 0}}, {{32767, 1000}, {0, 1000}}});
}

TEST_CASE("a closed line that is cut open is open, and one that is not ends where it began")
{
    const Stroke square{{{-100, -100}, {100, -100}, {100, 100}, {-100, 100}}, true};
    CHECK(drawn(square) == Lines{{{-100, -100}, {100, -100}, {100, 100}, {-100, 100}, {-100, -100}}});
    const Stroke cut{{{0, 0}, {40000, 0}, {40000, 9}, {0, 9}}, true};
    CHECK(drawn(cut) == Lines{{{0, 0}, {32767, 0}}, {{32767, 9}, {0, 9}, {0, 0}}});
}

TEST_CASE("what lies outside, or only touches the border, vanishes")
{
    CHECK(drawn({{{40000, 0}, {40000, 100}, {50000, -20}}}).empty());
    CHECK(drawn({{{-40000, 0}, {0, 40001}, {40000, 0}}}).size() == 2);
    CHECK(drawn({{{-65536, 0}, {0, 65537}}}).empty());
    CHECK(drawn({{{-65536, 0}, {0, 65536}}}).empty()); // through the corner
    CHECK(drawn({{{40000, 0}, {32768, 5}, {40000, 9}}}).empty());
    CHECK(drawn({{{32768, 5}, {40000, 9}}}).empty());
    CHECK(drawn({{{40000, 40000}}}).empty());
}

TEST_CASE("the border itself is in the field")
{
    CHECK(drawn({{{-32768, -32768}, {32768, -32768}, {32768, 32768}}}) ==
          Lines{{{-32768, -32768}, {32767, -32768}, {32767, 32767}}});
}

TEST_CASE("strokes without length are dots, the outlines of fills have none")
{
    CHECK(drawn({{{5, 6}, {5, 6}}}) == Lines{{{5, 6}}});
    CHECK(drawn({{{5, 6}, {5, 6}}, true}) == Lines{{{5, 6}}});
    CHECK(drawn({{{5, 6}, {5, 6}}}, BeamInk::outline).empty());
}

TEST_CASE("an outline closes what is filled as if it were closed, but not the parts of a broken stroke")
{
    const Stroke hook{{{0, 0}, {100, 0}, {100, 100}}};
    CHECK(drawn(hook) == Lines{{{0, 0}, {100, 0}, {100, 100}}});
    CHECK(drawn(hook, BeamInk::outline) == Lines{{{0, 0}, {100, 0}, {100, 100}, {0, 0}}});
    LineStore store;
    BeamPen pen{store.lines,      ViewProjection{nullptr, 0}, resolution,
                BeamInk::outline, {255, 255, 255, 255},       0};
    pen.begin(seen(0, 0));
    pen.add({.from = seen(0, 0), .to = seen(9, 0)});
    pen.end_part();
    CHECK(store.points(0) == std::vector<FieldPoint>{{0, 0}, {9, 0}});
}

TEST_CASE("what is left of random strokes is what lies in the field, whichever way they run")
{
    std::mt19937 random{4};
    for (int round = 0; round < rounds(4000); ++round) {
        const int bits = 15 + static_cast<int>(random() % 8); // up to 16383 px away
        Stroke stroke;
        for (auto left = 2 + random() % 8; left > 0; --left) {
            const auto far = [&] { return double(static_cast<std::int32_t>(random()) >> (31 - bits)); };
            const double x = far();
            stroke.corners.emplace_back(x, far());
        }
        double expected = 0;
        for (std::size_t i = 1; i < stroke.corners.size(); ++i) {
            const auto [x, y] = stroke.corners[i - 1];
            const auto [to_x, to_y] = stroke.corners[i];
            if (const auto in_field = stretch_in_field(x, y, to_x, to_y))
                expected += (in_field->second - in_field->first) * std::hypot(to_x - x, to_y - y);
        }
        Lines lines = drawn(stroke);
        CAPTURE(round);
        CHECK(length(lines) == doctest::Approx(expected).epsilon(0).scale(1).epsilon(
                                   1e-9 + 4.0 * double(stroke.corners.size()) / (1 + expected)));
        std::ranges::reverse(stroke.corners);
        Lines reversed = drawn(stroke);
        std::ranges::reverse(reversed);
        for (auto& line : reversed)
            std::ranges::reverse(line);
        CHECK(lines == reversed);
    }
}

TEST_CASE("places 16383 px away do not overflow at the finest resolution")
{
    for (const int fine : {64, 4096}) {
        LineStore store;
        BeamPen pen{store.lines, ViewProjection{nullptr, 0}, fine, BeamInk::stroke, {255, 255, 255, 255}, 0};
        const Point far{Fixed::pixels(16383), Fixed::pixels(16383)};
        pen.begin(-far);
        pen.add({.from = -far, .to = far});
        pen.end({}, false);
        REQUIRE(store.lines.size() == 1);
        CHECK(store.points(0) == std::vector<FieldPoint>{{-32768, 32767}, {32767, -32768}});
    }
}

TEST_CASE("coarser pens leave out corners that lie near, but no end")
{
    LineStore store;
    Stroke spiral;
    for (int i = 0; i <= 1000; ++i)
        spiral.corners.emplace_back(i * 10, (i % 2) * 5);
    draw(spiral, store.lines, BeamInk::stroke, 3);
    REQUIRE(store.lines.size() == 1);
    CHECK(store.lines.line(0).points < 120);
    CHECK(store.points(0).front() == FieldPoint{0, 0});
    CHECK(store.points(0).back() == FieldPoint{10000, 0});
}

}

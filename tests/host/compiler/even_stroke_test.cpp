#include "host/compiler/match/measured_stroke.hpp"

#include "tests/host/compiler/scene_parts.hpp"

#include <algorithm>
#include <array>
#include <doctest/doctest.h>
#include <random>

namespace kfast::test {
namespace {

MeasuredStroke even_curve(scene::Point from, scene::Point c1, scene::Point c2, scene::Point to)
{
    return made_even(measured(curve(from, c1, c2, to).strokes.front()));
}

Vec2 at_parameter(const MeasuredSegment& segment, double t)
{
    if (!segment.cubic)
        return between(segment.from, segment.to, t);
    const double s = 1 - t;
    return s * s * s * segment.from + 3 * s * s * t * segment.c1 + 3 * s * t * t * segment.c2 +
           t * t * t * segment.to;
}

/// How far the points at the same share of parameter and of length are apart, with finer steps than the
/// compiler's.
double worst_gap(const MeasuredSegment& segment)
{
    constexpr std::size_t steps = 1000;
    std::array<double, steps + 1> lengths{};
    for (std::size_t i = 1; i <= steps; ++i)
        lengths[i] = lengths[i - 1] + distance(at_parameter(segment, (static_cast<double>(i) - 1) / steps),
                                               at_parameter(segment, static_cast<double>(i) / steps));
    double worst = 0;
    for (std::size_t i = 1; i < 50; ++i) {
        const double share = static_cast<double>(i) / 50;
        const double length = share * lengths.back();
        const auto step =
            static_cast<std::size_t>(std::ranges::lower_bound(lengths, length) - lengths.begin());
        const double within = (length - lengths[step - 1]) / (lengths[step] - lengths[step - 1]);
        const double t = (static_cast<double>(step) - 1 + within) / steps;
        worst = std::max(worst, distance(at_parameter(segment, share), at_parameter(segment, t)));
    }
    return worst;
}

}

TEST_CASE("a segment that is even already stays as it is")
{
    const scene::Stroke line = lines({{0, 0}, {16000, 0}, {16000, 8}}).strokes.front();
    CHECK(rounded(made_even(measured(line))) == line);
    const scene::Stroke straight = curve({0, 0}, {1000, 0}, {2000, 0}, {3000, 0}).strokes.front();
    CHECK(rounded(made_even(measured(straight))) == straight);
    const scene::Stroke small = curve({0, 0}, {0, 0}, {8, 0}, {24, 0}).strokes.front();
    CHECK(rounded(made_even(measured(small))) == small);
}

TEST_CASE("an uneven curve is divided, also a straight one")
{
    const MeasuredStroke straight = even_curve({0, 0}, {0, 0}, {0, 0}, {3200, 0});
    CHECK(straight.size() > 8);
    for (const MeasuredSegment& segment : straight)
        CHECK(segment.length >= 1);
    CHECK(even_curve({0, 0}, {0, 1600}, {1600, 1600}, {1600, 0}).size() > 4);
}

TEST_CASE("in each segment, points at a share of the parameter are those at that share of the length")
{
    std::mt19937 random{71};
    const auto point = [&random] {
        const auto x = static_cast<std::int16_t>(random() % 6400 - 1600);
        return scene::Point{x, static_cast<std::int16_t>(random() % 6400 - 1600)};
    };
    for (int round = 0; round < 200; ++round) {
        const scene::Point from = point();
        const scene::Point c1 = point();
        const scene::Point c2 = point();
        const MeasuredStroke even = even_curve(from, c1, c2, point());
        double whole = 0;
        for (const MeasuredSegment& segment : even) {
            CHECK((segment.length < 2 || worst_gap(segment) <= 1 / 32.0 + 0.002));
            CHECK(segment.length > 0.9);
            whole += segment.length;
        }
        CHECK(even.size() < whole / 2);
    }
}

}

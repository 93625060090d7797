#include "core/pose/posed_backbones.hpp"

#include "tests/core/array_drawing.hpp"
#include "tests/core/raw_drawing.hpp"
#include "tests/core/spot.hpp"
#include "tests/rounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <random>
#include <vector>

namespace kfast::test {
namespace {

scene::Point near(scene::Point point, std::mt19937& random, int max)
{
    const auto by = [&random, max] { return std::uniform_int_distribution<int>{-max, max}(random); };
    return {static_cast<std::int16_t>(point.x + by()), static_cast<std::int16_t>(point.y + by())};
}

/// `segments` for each backbone, on a canvas of 512 px, outlines up to 100 px away.
scene::Drawing random_backbones(const std::vector<int>& segments, std::mt19937& random)
{
    scene::Drawing drawing;
    for (const int count : segments) {
        std::vector<scene::Point> nodes;
        for (int i = 0; i <= count; ++i)
            nodes.push_back(random_point(random));
        drawing.strokes.push_back(polyline_of(nodes));
        for (int side = 0; side < 2; ++side) {
            std::vector<scene::Point> outline;
            outline.reserve(nodes.size());
            for (const scene::Point node : nodes)
                outline.push_back(near(node, random, 16 * 70));
            drawing.strokes.push_back(polyline_of(outline));
        }
    }
    return drawing;
}

Spot mix(Spot a, Spot b, double share) { return a + share * (b - a); }

Spot mix(Spot a, Spot b, ProgressXY progress)
{
    return {a.x + progress.x.raw / 65536.0 * (b.x - a.x), a.y + progress.y.raw / 65536.0 * (b.y - a.y)};
}

Spot in_pixels(scene::Point point) { return {point.x / 16.0, point.y / 16.0}; }

std::vector<Spot> points_of(const scene::Stroke& stroke)
{
    std::vector<Spot> points{in_pixels(stroke.from)};
    for (const scene::Segment& segment : stroke.segments)
        points.push_back(in_pixels(segment.to));
    return points;
}

std::vector<Spot> points_between(const scene::Stroke& a, const scene::Stroke& b, ProgressXY progress)
{
    std::vector<Spot> points = points_of(a);
    const std::vector<Spot> ends = points_of(b);
    for (std::size_t i = 0; i < points.size(); ++i)
        points[i] = mix(points[i], ends[i], progress);
    return points;
}

/// P = C(l) + w (O(l) - C(l)), by the words of docs/format.md.
class ExactBackbones {
public:
    ExactBackbones(const scene::Drawing& from, const scene::Drawing& to, ProgressXY progress,
                   std::uint32_t unit_bits)
        : unit_{std::exp2(unit_bits) / 16}
    {
        for (std::size_t stroke = 0; stroke < from.strokes.size(); stroke += 3) {
            const auto live = [&](std::size_t part) {
                return points_between(from.strokes[stroke + part], to.strokes[stroke + part], progress);
            };
            backbones_.push_back({live(0), live(1), live(2)});
        }
    }

    /// A place on a backbone, in segments, and a width; both in relative coordinates.
    Spot relative(std::size_t backbone, double along, double width) const
    {
        return {(begin(backbone) + along) * unit_, width * unit_};
    }

    Spot place(std::size_t backbone, Spot relative) const
    {
        const auto& [middle, left, right] = backbones_[backbone];
        const double segments = static_cast<double>(middle.size()) - 1;
        const double along = std::clamp(relative.x / unit_ - begin(backbone), -1.0, segments + 1);
        const double cell = std::clamp(std::floor(along), 0.0, segments - 1);
        const auto node = static_cast<std::size_t>(cell);
        const std::vector<Spot>& side = relative.y >= 0 ? left : right;
        const Spot on_middle = mix(middle[node], middle[node + 1], along - cell);
        const Spot on_side = mix(side[node], side[node + 1], along - cell);
        return mix(on_middle, on_side, std::min(std::abs(relative.y) / unit_, 8.0));
    }

    std::size_t count() const { return backbones_.size(); }
    double segments(std::size_t backbone) const
    {
        return static_cast<double>(backbones_[backbone].middle.size()) - 1;
    }

private:
    struct Backbone {
        std::vector<Spot> middle;
        std::vector<Spot> left;
        std::vector<Spot> right;
    };

    double begin(std::size_t backbone) const
    {
        double sum = 0;
        for (std::size_t before = 0; before < backbone; ++before)
            sum += segments(before) + 2;
        return sum;
    }

    std::vector<Backbone> backbones_;
    double unit_;
};

/// Both on the way between two drawings.
class Pair {
public:
    Pair(const scene::Drawing& from, const scene::Drawing& to, ProgressXY progress, std::uint32_t unit_bits)
        : from_{packed(from)},
          to_{packed(to)},
          nodes_(backbone_node_count(drawing_at(from_, 0))),
          live{nodes_, unit_bits, drawing_at(from_, 0), drawing_at(to_, 0), progress},
          exact{from, to, progress, unit_bits}
    {
    }

private:
    Bytes from_;
    Bytes to_;
    std::vector<BackboneNode> nodes_;

public:
    PosedBackbones live;
    ExactBackbones exact;
};

double uniform(std::mt19937& random, double min, double max)
{
    return std::uniform_real_distribution<double>{min, max}(random);
}

ProgressXY random_progress(std::mt19937& random)
{
    const auto progress = [&random] {
        return Progress{std::uniform_int_distribution<int>{0, Progress::one}(random)};
    };
    const Progress x = progress();
    return {x, random() % 2 == 0 ? x : progress()};
}

std::vector<int> random_segments(std::mt19937& random)
{
    std::vector<int> segments(1 + random() % 3);
    for (int& count : segments)
        count = 1 + static_cast<int>(random() % 4);
    return segments;
}

/// Rounded to 1/16 px, as they are stored.
Point stored(Spot relative)
{
    const auto sixteenths = [](double value) {
        return Fixed::sixteenths(static_cast<std::int32_t>(std::lround(value * 16)));
    };
    return {sixteenths(relative.x), sixteenths(relative.y)};
}

/// Of 2^11 sixteenths: 20 segments and gaps fit into 16 bits.
constexpr std::uint32_t unit_bits = 10;

/// Two nodes at (16, 32) and (48, 32) px, outlines 8 px to the left, which is up, and 4 px to the right.
scene::Drawing level()
{
    return {{polyline_of({{256, 512}, {768, 512}}), polyline_of({{256, 384}, {768, 384}}),
             polyline_of({{256, 576}, {768, 576}})}};
}

Point placed_on_level(double along, double width)
{
    const Pair pair{level(), level(), {}, unit_bits};
    return pair.live.place(stored(pair.exact.relative(0, along, width)));
}

}

TEST_CASE("nodes and gaps are counted, not those of the outlines")
{
    std::mt19937 random{91};
    const Bytes one = packed(random_backbones({3}, random));
    CHECK(backbone_node_count(drawing_at(one, 0)) == 5);
    const Bytes three = packed(random_backbones({1, 2, 4}, random));
    CHECK(backbone_node_count(drawing_at(three, 0)) == 3 + 4 + 6);
}

TEST_CASE("points lie along the backbone and across it, the left side up where it leads to the right")
{
    CHECK(placed_on_level(0, 0) == pixels(16, 32));
    CHECK(placed_on_level(1, 0) == pixels(48, 32));
    CHECK(placed_on_level(0.25, 0) == pixels(24, 32));
    CHECK(placed_on_level(0, 1) == pixels(16, 24));
    CHECK(placed_on_level(0.5, 0.5) == pixels(32, 28));
    CHECK(placed_on_level(1, -1) == pixels(48, 36));
    CHECK(placed_on_level(0.5, -0.5) == pixels(32, 34));
    CHECK(placed_on_level(0.5, 2) == pixels(32, 16));
    CHECK(placed_on_level(0.5, -2) == pixels(32, 40));
}

TEST_CASE("points lie up to one segment before the beginning and behind the end")
{
    CHECK(placed_on_level(-0.5, 0) == pixels(0, 32));
    CHECK(placed_on_level(-1, 1) == pixels(-16, 24));
    CHECK(placed_on_level(1.5, -1) == pixels(64, 36));
    CHECK(placed_on_level(2, 0) == pixels(80, 32));
    CHECK(placed_on_level(-1.5, 0) == pixels(-16, 32));
    CHECK(placed_on_level(-9, 1) == pixels(-16, 24));
    CHECK(placed_on_level(2.5, 0) == pixels(80, 32));
    CHECK(placed_on_level(9, -1) == pixels(80, 36));
}

TEST_CASE("a width is held within 8")
{
    CHECK(placed_on_level(0, 8) == pixels(16, 32 - 64));
    CHECK(placed_on_level(0, 9) == pixels(16, 32 - 64));
    CHECK(placed_on_level(0, -20) == pixels(16, 32 + 32));
}

TEST_CASE("any place on any backbone is within 1/64 px of the exact one, at every unit")
{
    std::mt19937 random{92};
    double worst = 0;
    for (int round = 0; round < rounds(5000); ++round) {
        const std::vector<int> segments = random_segments(random);
        const scene::Drawing from = random_backbones(segments, random);
        const auto bits = 4 + static_cast<std::uint32_t>(random() % 7);
        const Pair pair{from, random_drawing_like(from, random), random_progress(random), bits};
        for (std::size_t backbone = 0; backbone < pair.exact.count(); ++backbone) {
            const double along = uniform(random, -0.9, pair.exact.segments(backbone) + 0.9);
            const Point at = stored(pair.exact.relative(backbone, along, uniform(random, -2, 2)));
            const Spot exact = pair.exact.place(backbone, spot(at));
            worst = std::max(worst, apart(pair.live.place(at), exact));
        }
    }
    CHECK(worst < 1.0 / 64);
}

TEST_CASE("a way within one backbone leads through relative coordinates")
{
    std::mt19937 random{93};
    double worst = 0;
    for (int round = 0; round < rounds(5000); ++round) {
        const scene::Drawing from = random_backbones(random_segments(random), random);
        const Pair pair{from, random_drawing_like(from, random), random_progress(random), unit_bits};
        const std::size_t backbone = random() % pair.exact.count();
        const auto random_place = [&] {
            const double along = uniform(random, -0.9, pair.exact.segments(backbone) + 0.9);
            return stored(pair.exact.relative(backbone, along, uniform(random, -2, 2)));
        };
        const Point a = random_place();
        const Point b = random_place();
        const ProgressXY progress = random_progress(random);
        const Spot exact = pair.exact.place(backbone, mix(spot(a), spot(b), progress));
        worst = std::max(worst, apart(pair.live.between(a, b, progress), exact));
    }
    CHECK(worst < 1.0 / 16);
}

TEST_CASE("a way from one backbone to another leads straight from place to place")
{
    std::mt19937 random{94};
    double worst = 0;
    for (int round = 0; round < rounds(3000); ++round) {
        const scene::Drawing from = random_backbones({2, 3}, random);
        const Pair pair{from, random_drawing_like(from, random), random_progress(random), unit_bits};
        const Point a = stored(pair.exact.relative(0, uniform(random, -0.9, 2.9), uniform(random, -2, 2)));
        const Point b = stored(pair.exact.relative(1, uniform(random, -0.9, 3.9), uniform(random, -2, 2)));
        const ProgressXY progress = random_progress(random);
        const Spot exact = mix(pair.exact.place(0, spot(a)), pair.exact.place(1, spot(b)), progress);
        worst = std::max(worst, apart(pair.live.between(a, b, progress), exact));
    }
    CHECK(worst < 1.0 / 64);
}

TEST_CASE("a way that swings beyond its ends stays on its backbone")
{
    const scene::Drawing both{{level().strokes[0], level().strokes[1], level().strokes[2],
                               polyline_of({{8000, 8000}, {8000, 7000}}),
                               polyline_of({{8000, 8000}, {8000, 7000}}),
                               polyline_of({{8000, 8000}, {8000, 7000}})}};
    const Pair pair{both, both, {}, unit_bits};
    const Point a = stored(pair.exact.relative(0, 0, 0));
    const Point b = stored(pair.exact.relative(0, 1.9, 0));
    const Progress far{5 * Progress::one / 2};
    CHECK(pair.live.between(a, b, {far, far}) == pixels(80, 32));
    const Point c = stored(pair.exact.relative(1, 0, 0));
    const Point d = stored(pair.exact.relative(1, 1.9, 0));
    CHECK(pair.live.between(d, c, {far, far}) == pixels(500, 562.5));
}

TEST_CASE("nodes that are far apart, and ways that swing far, are held and do not wrap")
{
    std::mt19937 random{96};
    const auto corner = [&random]() -> scene::Point {
        const auto side = [&random] { return static_cast<std::int16_t>(random() % 2 == 0 ? -32768 : 32767); };
        const std::int16_t x = side();
        return {x, side()};
    };
    for (int round = 0; round < 1000; ++round) {
        scene::Drawing wide;
        for (int stroke = 0; stroke < 3; ++stroke)
            wide.strokes.push_back(polyline_of({corner(), corner(), corner()}));
        scene::Drawing other = wide;
        for (scene::Stroke& stroke : other.strokes)
            stroke.from = corner();
        const Progress swung{random() % 2 == 0 ? -3 * Progress::one / 2 : 5 * Progress::one / 2};
        const Pair pair{wide, other, {swung, swung}, 4};
        const auto anywhere = [&random] {
            return Point{Fixed::sixteenths(static_cast<std::int16_t>(random())),
                         Fixed::sixteenths(static_cast<std::int16_t>(random()))};
        };
        const Point placed = pair.live.place(anywhere());
        const Point between = pair.live.between(anywhere(), anywhere(), {swung, swung});
        for (const Fixed side : {placed.x, placed.y})
            CHECK(std::abs(side.raw()) <= Fixed::pixels(4095).raw());
        for (const Fixed side : {between.x, between.y})
            CHECK(std::abs(side.raw()) <= Fixed::pixels(16380).raw());
    }
}

}

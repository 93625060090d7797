#include "core/math/fixed.hpp"
#include "core/pose/equalize.hpp"
#include "host/compiler/match/match_by_count.hpp"
#include "tests/host/compiler/matched_drawings.hpp"

#include <algorithm>
#include <random>

namespace kfast::test {
namespace {

scene::Point random_point(std::mt19937& random, unsigned reach)
{
    const auto coordinate = [&random, reach] {
        return static_cast<std::int16_t>(static_cast<int>(random() % (2 * reach + 1)) -
                                         static_cast<int>(reach));
    };
    const std::int16_t x = coordinate();
    return {x, coordinate()};
}

void add_if_extended(scene::Stroke& stroke, const scene::Segment& segment)
{
    const scene::Point at = vertices(stroke).back();
    if (segment.to != at || (segment.cubic && (segment.c1 != at || segment.c2 != at)))
        stroke.segments.push_back(segment);
}

/// From specks, where points fall on each other, to the size of a large canvas; some single points, some
/// closed.
scene::Stroke random_stroke(std::mt19937& random)
{
    const unsigned reach = 2U << random() % 13;
    scene::Stroke stroke{random_point(random, reach), {}};
    for (auto left = random() % 9; left > 0; --left) {
        scene::Segment segment{
            .cubic = random() % 2 == 0, .c1 = {}, .c2 = {}, .to = random_point(random, reach)};
        if (segment.cubic) {
            segment.c1 = random_point(random, reach);
            segment.c2 = random_point(random, reach);
        }
        add_if_extended(stroke, segment);
    }
    if (random() % 2 == 0)
        add_if_extended(stroke, {.cubic = false, .c1 = {}, .c2 = {}, .to = stroke.from});
    return stroke;
}

scene::Drawing random_drawing(std::mt19937& random)
{
    scene::Drawing result;
    for (auto left = random() % 5; left > 0; --left)
        result.strokes.push_back(random_stroke(random));
    return result;
}

std::vector<Segment> segments_of(const scene::Drawing& drawing)
{
    std::vector<Segment> segments;
    ModelReader reader{drawing};
    for (std::uint32_t stroke = 0; stroke < reader.strokes(); ++stroke)
        for (std::uint32_t left = reader.next_stroke(); left > 0; --left)
            segments.push_back(reader.next_segment());
    return segments;
}

/// What equalization yields of one side, for each of the matched strokes.
using Yield = std::vector<std::vector<Segment>>;

Pair<Yield> equalized(const MatchedDrawings& drawings)
{
    Pair<Yield> yield;
    EqualizedPair pair{ModelReader{drawings.from}, ModelReader{drawings.to}};
    while (const std::uint32_t segments = pair.next_stroke()) {
        yield.a.emplace_back();
        yield.b.emplace_back();
        for (std::uint32_t i = 0; i < segments; ++i) {
            const Pair<Segment> both = pair.next_segment();
            yield.a.back().push_back(both.a);
            yield.b.back().push_back(both.b);
        }
    }
    return yield;
}

/// The drawing's own segments, to the bit, lines beside curves as curves, or repeated single points.
void check_nothing_added(const Yield& yield, const scene::Drawing& drawing)
{
    const Distribution parts{static_cast<std::uint32_t>(yield.size()),
                             static_cast<std::uint32_t>(drawing.strokes.size())};
    auto part = yield.begin();
    for (std::uint32_t i = 0; i < drawing.strokes.size(); ++i) {
        const scene::Stroke& stroke = drawing.strokes[i];
        std::vector<Segment> segments;
        for (std::uint32_t left = parts.at(i); left > 0; --left, ++part)
            segments.insert(segments.end(), part->begin(), part->end());
        std::vector<Segment> own = segments_of({{stroke}});
        if (stroke.segments.empty())
            own.assign(segments.size(), still_segment(segments.front().from));
        REQUIRE(segments.size() == own.size());
        for (std::size_t segment = 0; segment < own.size(); ++segment) {
            Pair<Segment> both{own[segment], segments[segment]};
            make_same_kind(both); // a line beside a curve
            CHECK(both.a == segments[segment]);
        }
    }
}

double distance_to(Vec2 at, Vec2 a, Vec2 b)
{
    const double squared = dot(b - a, b - a);
    const double share = squared == 0 ? 0 : std::clamp(dot(at - a, b - a) / squared, 0.0, 1.0);
    return distance(at, between(a, b, share));
}

/// A curve in many straight pieces.
std::vector<Vec2> traced(const scene::Stroke& stroke, std::uint32_t pieces)
{
    std::vector<Vec2> spots{in_pixels(stroke.from)};
    for (const Segment& segment : segments_of({{stroke}}))
        for (std::uint32_t piece = 1; piece <= pieces; ++piece)
            if (segment.kind == Segment::Kind::cubic || piece == pieces)
                spots.push_back(in_pixels(point_at(segment, Fraction::ratio(piece, pieces))));
    return spots;
}

/// How far the points of `stroke` are from `other` at most.
double departure(const scene::Stroke& stroke, const scene::Stroke& other)
{
    const std::vector<Vec2> way = traced(other, 256);
    double worst = 0;
    for (const Vec2 at : traced(stroke, 8)) {
        double nearest = distance(at, way.front());
        for (std::size_t i = 1; i < way.size(); ++i)
            nearest = std::min(nearest, distance_to(at, way[i - 1], way[i]));
        worst = std::max(worst, nearest);
    }
    return worst;
}

/// Points are rounded to 1/16 px, and the straight pieces of this test may be 1/32 px off.
constexpr double tolerance = 1.0 / 16 + 1.0 / 32;

void check_looks_alike(const scene::Stroke& original, const scene::Stroke& stroke)
{
    CHECK(departure(stroke, original) <= tolerance);
    CHECK(departure(original, stroke) <= tolerance);
    const std::vector<scene::Point> points = vertices(stroke);
    for (const scene::Point point : vertices(original))
        CHECK(std::ranges::count(points, point) > 0);
    const bool is_closed = vertices(original).back() == original.from;
    CHECK((points.back() == stroke.from) == is_closed);
    if (!is_closed) {
        CHECK(points.front() == original.from);
        CHECK(points.back() == vertices(original).back());
    }
}

}

TEST_CASE("random drawings: they look as they did, and equalization adds nothing")
{
    std::mt19937 random{31};
    for (int round = 0; round < 100; ++round) {
        const scene::Drawing a = random_drawing(random);
        const scene::Drawing b = random_drawing(random);
        const MatchedDrawings drawings = matched(a, b);
        REQUIRE(drawings.from.strokes.size() == a.strokes.size());
        REQUIRE(drawings.to.strokes.size() == b.strokes.size());
        for (std::size_t i = 0; i < a.strokes.size(); ++i)
            check_looks_alike(a.strokes[i], drawings.from.strokes[i]);
        for (std::size_t i = 0; i < b.strokes.size(); ++i)
            check_looks_alike(b.strokes[i], drawings.to.strokes[i]);
        if (a.strokes.empty() || b.strokes.empty())
            continue;
        const Pair<Yield> yield = equalized(drawings);
        check_nothing_added(yield.a, drawings.from);
        check_nothing_added(yield.b, drawings.to);
    }
}

}

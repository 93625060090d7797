#include "host/compiler/match/match_by_length.hpp"

#include "core/pose/equalize.hpp"
#include "core/scene/kfb_limits.hpp"
#include "host/compiler/match/match_by_count.hpp"
#include "host/geometry/shape.hpp"
#include "host/geometry/svg_path.hpp"
#include "tests/host/compiler/matched_drawings.hpp"

#include <algorithm>
#include <numbers>
#include <string_view>

namespace kfast::test {
namespace {

scene::Drawing drawing(std::string_view path)
{
    Diagnostics findings;
    scene::Drawing result;
    for (const scene::Outline& outline : scene::read_svg_path(path, 1000, findings))
        result.strokes.push_back(scene::quantized(outline));
    REQUIRE(!findings.has_errors());
    return result;
}

/// From three o'clock, clockwise, in four curves.
scene::Stroke circle(double x, double y, double radius)
{
    return scene::quantized(scene::ellipse({x, y}, radius, radius));
}

/// The strokes on the way, as the player has them: their vertices and the points of curves between them.
std::vector<std::vector<Vec2>> live(const MatchedDrawings& drawings, Progress progress)
{
    std::vector<std::vector<Vec2>> strokes;
    EqualizedPair pair{ModelReader{drawings.from}, ModelReader{drawings.to}};
    while (const std::uint32_t segments = pair.next_stroke()) {
        std::vector<Vec2> spots;
        for (std::uint32_t i = 0; i < segments; ++i) {
            const Pair<Segment> both = pair.next_segment();
            const Segment segment = tween(both.a, both.b, progress, progress);
            for (std::uint32_t piece = 0; piece < 16; ++piece)
                spots.push_back(in_pixels(point_at(segment, Fraction::ratio(piece, 16))));
            if (i + 1 == segments)
                spots.push_back(in_pixels(segment.to));
        }
        strokes.push_back(spots);
    }
    return strokes;
}

constexpr Progress half{Progress::one / 2};

/// What a closed stroke goes around; positive if clockwise.
double area(const std::vector<Vec2>& spots)
{
    double twice = cross(spots.back(), spots.front());
    for (std::size_t i = 1; i < spots.size(); ++i)
        twice += cross(spots[i - 1], spots[i]);
    return twice / 2;
}

std::vector<Vec2> corners(const scene::Stroke& stroke)
{
    std::vector<Vec2> spots;
    for (const scene::Point point : vertices(stroke))
        spots.push_back(in_pixels(point));
    return spots;
}

/// The angle between the directions of two spots, seen from a centre, in degrees.
double angle_between(Vec2 a, Vec2 b)
{
    return std::acos(std::clamp(dot(a, b) / std::sqrt(dot(a, a) * dot(b, b)), -1.0, 1.0)) * 180 /
           std::numbers::pi;
}

/// A five-pointed star that begins at the top, clockwise.
scene::Drawing star(double x, double y, double radius)
{
    std::vector<Vec2> spots;
    for (int i = 0; i < 10; ++i) {
        const double angle = std::numbers::pi / 5 * i;
        const double away = i % 2 == 0 ? radius : radius * 0.4;
        spots.push_back({x + away * std::sin(angle), y - away * std::cos(angle)});
    }
    return {{scene::quantized(scene::polyline(spots, true))}};
}

constexpr std::string_view square = "M 20 20 H 100 V 100 H 20 Z";

}

TEST_CASE("a square that begins two corners later keeps its size on the way")
{
    const MatchedDrawings drawings = matched(drawing(square), drawing("M 110 110 H 30 V 30 H 110 Z"));
    CHECK(drawings.from == drawing(square));
    CHECK(drawings.to == drawing("M 30 30 H 110 V 110 H 30 Z"));
    CHECK(area(live(drawings, half).front()) == doctest::Approx(80 * 80));
}

TEST_CASE("a circle becomes a star without turning")
{
    const MatchedDrawings drawings = matched({{circle(60, 60, 50)}}, star(60, 60, 55));
    const std::vector<Vec2> from = corners(drawings.from.strokes.front());
    const std::vector<Vec2> to = corners(drawings.to.strokes.front());
    REQUIRE(from.size() == to.size());
    CHECK(from.size() - 1 == 12); // the star's ten; two of the circle's four are where the star has one
    for (std::size_t i = 0; i < from.size(); ++i)
        CHECK(angle_between(from[i] - Vec2{60, 60}, to[i] - Vec2{60, 60}) < 9);
}

TEST_CASE("a circle becomes a square without turning, with new points for the corners")
{
    const MatchedDrawings drawings = matched({{circle(60, 60, 50)}}, drawing(square));
    const std::vector<Vec2> from = corners(drawings.from.strokes.front());
    const std::vector<Vec2> to = corners(drawings.to.strokes.front());
    REQUIRE(from.size() == 9);
    for (std::size_t i = 0; i < from.size(); ++i)
        CHECK(angle_between(from[i] - Vec2{60, 60}, to[i] - Vec2{60, 60}) < 0.2);
}

TEST_CASE("corners meet corners, though not at the same share of the length")
{
    const MatchedDrawings drawings = matched(drawing(square), drawing("M 5 40 H 115 V 60 H 5 Z"));
    CHECK(drawings.from.strokes.front().segments.size() == 4);
    CHECK(area(live(drawings, half).front()) == doctest::Approx(95 * 50));
}

TEST_CASE("corners that point elsewhere do not meet: a square becomes a diamond by way of an octagon")
{
    const MatchedDrawings drawings = matched(drawing(square), drawing("M 60 0 L 120 60 L 60 120 L 0 60 Z"));
    CHECK(drawings.from.strokes.front().segments.size() == 8);
    const std::vector<std::vector<Vec2>> octagon = live(drawings, half);
    for (const Vec2 at : octagon.front())
        CHECK(distance(at, {60, 60}) > 45);
}

TEST_CASE("a triangle becomes a square evenly, its tip in the middle of a side")
{
    const MatchedDrawings drawings =
        matched(drawing("M 60 20 L 110 100 L 10 100 Z"), drawing("M 60 20 H 100 V 100 H 20 V 20 Z"));
    const std::vector<scene::Point> from = vertices(drawings.from.strokes.front());
    const std::vector<scene::Point> to = vertices(drawings.to.strokes.front());
    CHECK(from.size() == 6);
    for (std::size_t i = 0; i < from.size(); ++i)
        CHECK((from[i] == scene::Point{60 * 16, 20 * 16}) == (to[i] == scene::Point{60 * 16, 20 * 16}));
}

TEST_CASE("what a long segment displaces is paired all the same")
{
    const scene::Drawing bends = drawing("M 0 0 H 20 V 20 H 0 V 40 H 20");
    const scene::Drawing with_tail = drawing("M -80 0 H 20 V 20 H 0 V 40 H 20");
    const MatchedDrawings drawings = matched(bends, with_tail);
    CHECK(drawings.from == bends);
    CHECK(drawings.to == with_tail);
}

TEST_CASE("one has points in proportion to the lengths that the other's vertices divide it into")
{
    const scene::Drawing bent = drawing("M 0 0 L 40 0 L 40 10 L 90 10");
    const MatchedDrawings drawings = matched(drawing("M 0 50 L 200 50"), bent);
    CHECK(drawings.from == drawing("M 0 50 L 80 50 L 100 50 L 200 50"));
    CHECK(drawings.to == bent);
}

TEST_CASE("a single stroke may change its direction, one of several not")
{
    const std::string_view clockwise = "M 60 10 L 110 100 L 10 100 Z";
    const std::string_view counter_clockwise = "M 60 10 L 10 100 L 110 100 Z";
    SUBCASE("single strokes")
    {
        const MatchedDrawings drawings = matched(drawing(clockwise), drawing(counter_clockwise));
        CHECK(drawings.to == drawings.from);
        CHECK(area(live(drawings, half).front()) == doctest::Approx(4500));
        CHECK(matched(drawing(clockwise), drawing(clockwise)).to == drawing(clockwise));
    }
    SUBCASE("a hole stays a hole")
    {
        const scene::Stroke hole = drawing("M 60 40 L 50 80 L 70 80 Z").strokes.front();
        const scene::Stroke plate = drawing("M 80 40 L 90 80 L 40 80 Z").strokes.front();
        scene::Drawing a = drawing(clockwise);
        scene::Drawing b = a;
        a.strokes.push_back(hole);
        b.strokes.push_back(plate);
        const auto side = [](const scene::Drawing& of) { return area(corners(of.strokes[1])); };
        const MatchedDrawings drawings = matched(a, b);
        CHECK(side(drawings.from) < 0);
        CHECK(side(drawings.to) > 0);
    }
}

TEST_CASE("an open stroke keeps its start, a closed one opens where the open one does")
{
    const scene::Drawing letter = drawing("M 90 30 A 42 42 0 1 0 90 90");
    const MatchedDrawings drawings = matched(letter, {{circle(60, 60, 50)}});
    CHECK(drawings.from.strokes.front().from == letter.strokes.front().from);
    const Vec2 start = in_pixels(drawings.to.strokes.front().from);
    CHECK(distance(start, {110, 60}) < 2);
    CHECK(area(corners(drawings.to.strokes.front())) < 0); // it has changed its direction
}

TEST_CASE("a stroke is broken in proportion to the lengths of its partners")
{
    const MatchedDrawings drawings =
        matched(drawing("M 0 0 L 100 0"), drawing("M 0 20 L 10 20 M 30 20 L 45 20 L 60 20"));
    CHECK(drawings.from == drawing("M 0 0 L 12.5 0 L 25 0 L 62.5 0 L 100 0"));
    CHECK(drawings.to == drawing("M 0 20 L 5 20 L 10 20 M 30 20 L 45 20 L 60 20"));
}

TEST_CASE("a stroke breaks at a vertex that is near")
{
    const scene::Drawing whole = drawing("M 0 0 H 50 V 50");
    const scene::Drawing first_longer = drawing("M 0 80 H 51 M 0 90 H 50");
    const scene::Drawing first_shorter = drawing("M 0 80 H 50 M 0 90 H 51");
    CHECK(matched(whole, first_longer).from == whole);
    CHECK(matched(whole, first_shorter).from == whole);
    CHECK(matched(whole, drawing("M 0 80 H 60 M 0 90 H 50")).from.strokes.front().segments.size() == 4);
}

TEST_CASE("the part of a single point is short, but it has a length")
{
    const MatchedDrawings drawings = matched(drawing("M 5 9 Z M 0 20 L 30 20"), drawing("M 0 0 L 132 0"));
    CHECK(drawings.from == drawing("M 5 9 Z M 0 20 L 30 20"));
    CHECK(drawings.to == drawing("M 0 0 L 4 0 L 132 0"));
}

TEST_CASE("a closed stroke breaks where its parts lie next to what they become")
{
    const scene::Drawing whole{{scene::quantized(scene::ellipse({60, 60}, 55, 25))}};
    const scene::Drawing two{{circle(25, 60, 20), circle(95, 60, 20)}};
    for (const MatchedDrawings& drawings : {matched(whole, two), [&] {
                                                MatchedDrawings back = matched(two, whole);
                                                std::swap(back.from, back.to);
                                                return back;
                                            }()}) {
        CHECK(drawings.from.strokes.front().from == scene::Point{60 * 16, 85 * 16});
        const std::vector<std::vector<Vec2>> parts = live(drawings, half);
        for (const Vec2 at : parts.front())
            CHECK(at.x < 60.1);
        for (const Vec2 at : parts.back())
            CHECK(at.x > 59.9);
        CHECK(drawings.to.strokes.front().from == scene::Point{45 * 16, 60 * 16});
        CHECK(drawings.to.strokes.back().from == scene::Point{75 * 16, 60 * 16});
    }
}

TEST_CASE("a part that happens to end where it begins stays where it is")
{
    const scene::Drawing eight = drawing("M 60 60 L 20 40 V 80 L 60 60 L 100 40 V 80 L 60 61");
    const MatchedDrawings drawings =
        matched(eight, drawing("M 0 40 V 80 H 40 V 40 Z M 80 40 V 80 H 120 V 40 Z"));
    const std::vector<scene::Point> all = vertices(drawings.from.strokes.front());
    auto at = all.begin();
    for (const scene::Point point : vertices(eight.strokes.front())) {
        at = std::find(at, all.end(), point);
        REQUIRE(at != all.end());
    }
}

TEST_CASE("nothing and single points stay what they are")
{
    const scene::Drawing shape = drawing("M 10 10 C 40 10 40 40 10 40 Z M 60 60 H 80");
    const scene::Drawing point = drawing("M 7 8 Z");
    for (const scene::Drawing& other : {scene::Drawing{}, point}) {
        const MatchedDrawings drawings = matched(shape, other);
        CHECK(drawings.from == shape);
        CHECK(drawings.to == other);
    }
    CHECK(matched({}, {}).from.strokes.empty());
    CHECK(matched(point, point).to == point);
}

TEST_CASE("a drawing of more points than the format holds is refused")
{
    const auto zigzag = [](std::size_t segments) {
        scene::Stroke stroke{{0, 0}, {}};
        for (std::size_t i = 1; i <= segments; ++i)
            stroke.segments.push_back(
                {.cubic = false,
                 .c1 = {},
                 .c2 = {},
                 .to = {static_cast<std::int16_t>(i % 2), static_cast<std::int16_t>(i / 4)}});
        return scene::Drawing{{stroke}};
    };
    /// All but one of the points are in the first part of the length.
    const auto crowded = [&zigzag](std::size_t segments) {
        scene::Drawing result = zigzag(segments);
        result.strokes.front().segments.push_back(
            {.cubic = false, .c1 = {}, .c2 = {}, .to = {32'000, 15'000}});
        return result;
    };
    SUBCASE("one stroke")
    {
        const scene::Drawing max = zigzag(kfb::max_drawing_points - 1);
        CHECK(match_by_length(max, max));
        CHECK(match_by_length(crowded(60'000), zigzag(3'000)));
        CHECK(!match_by_length(crowded(60'000), zigzag(30'000)));
    }
    SUBCASE("two strokes together")
    {
        const auto twice = [](scene::Drawing single) {
            single.strokes.push_back(single.strokes.front());
            return single;
        };
        CHECK(match_by_length(crowded(20'000), zigzag(30'000)));
        CHECK(!match_by_length(twice(crowded(20'000)), twice(zigzag(30'000))));
    }
    SUBCASE("a stroke that is broken, each part with as many points as the largest")
    {
        scene::Drawing many = zigzag(1000);
        for (int i = 0; i < 70; ++i)
            many.strokes.push_back(drawing("M 1 1 H 9").strokes.front());
        CHECK(!match_by_length(many, drawing(square)));
    }
}

}

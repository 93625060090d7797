#include "core/scene/drawing_view.hpp"

#include "core/math/flatten.hpp"
#include "core/pose/equalize.hpp"
#include "core/time/velocity_law.hpp"
#include "tests/core/array_drawing.hpp"

#include <array>
#include <doctest/doctest.h>
#include <random>
#include <type_traits>
#include <vector>

namespace kfast::test {
namespace {

constexpr Point at(int x, int y) { return {Fixed::pixels(x), Fixed::pixels(y)}; }

constexpr std::array zigzag{at(0, 0), at(4, 8), at(8, 0)};
constexpr std::array leaf{Segment{Segment::Kind::cubic, at(0, 0), at(0, 9), at(9, 9), at(9, 0)},
                          Segment{.from = at(9, 0), .to = at(0, 0)}};
constexpr std::array dot{at(7, 7)};
constexpr std::span<const Point> nothing;

/// All that a reader tells: the first point and the segments of every stroke.
template <DrawingReader R>
ArrayDrawing all_of(R reader)
{
    ArrayDrawing strokes(reader.strokes());
    for (ArrayStroke& stroke : strokes) {
        stroke.segments.resize(reader.next_stroke());
        stroke.start = reader.start();
        for (Segment& segment : stroke.segments)
            segment = reader.next_segment();
    }
    return strokes;
}

/// The vertices of one side, stroke by stroke, and whether the strokes are whole.
struct Matched {
    std::vector<std::vector<Point>> a;
    std::vector<std::vector<Point>> b;
    bool all_whole = true;
};

Matched matched(DrawingView a, DrawingView b)
{
    Matched strokes;
    EqualizedPair pair{a, b};
    while (const std::uint32_t segments = pair.next_stroke()) {
        Pair<Segment> both = pair.next_segment();
        strokes.a.push_back({both.a.from, both.a.to});
        strokes.b.push_back({both.b.from, both.b.to});
        for (std::uint32_t i = 1; i < segments; ++i) {
            both = pair.next_segment();
            strokes.a.back().push_back(both.a.to);
            strokes.b.back().push_back(both.b.to);
        }
        strokes.all_whole = strokes.all_whole && pair.is_whole();
    }
    return strokes;
}

constexpr Point last_point_of_the_second_stroke()
{
    constexpr std::array strokes{StrokeView{zigzag}, StrokeView{leaf}};
    DrawingView drawing{strokes};
    drawing.next_stroke();
    drawing.next_stroke();
    drawing.next_segment();
    return drawing.next_segment().to;
}

static_assert(std::is_constructible_v<StrokeView, const std::array<Point, 2>&>);
static_assert(!std::is_constructible_v<StrokeView, std::array<Point, 2>>, "a temporary would be gone");
static_assert(!std::is_constructible_v<StrokeView, std::array<Segment, 2>>);
static_assert(std::is_constructible_v<DrawingView, const std::array<StrokeView, 2>&>);
static_assert(!std::is_constructible_v<DrawingView, std::array<StrokeView, 2>>);

static_assert(last_point_of_the_second_stroke() == at(0, 0), "drawings can be read by the compiler");

}

TEST_CASE("points are joined by straight lines, segments are as they are")
{
    constexpr std::array strokes{StrokeView{zigzag}, StrokeView{leaf}};
    const ArrayDrawing read = all_of(DrawingView{strokes});
    REQUIRE(read.size() == 2);
    CHECK(read[0].start == at(0, 0));
    CHECK(read[0].segments ==
          std::vector<Segment>{{.from = at(0, 0), .to = at(4, 8)}, {.from = at(4, 8), .to = at(8, 0)}});
    CHECK(read[1].start == at(0, 0));
    CHECK(read[1].segments == std::vector<Segment>(leaf.begin(), leaf.end()));
}

TEST_CASE("one point is a dot: a stroke without segments")
{
    constexpr std::array strokes{StrokeView{dot}};
    const ArrayDrawing read = all_of(DrawingView{strokes});
    REQUIRE(read.size() == 1);
    CHECK(read[0].start == at(7, 7));
    CHECK(read[0].segments.empty());
}

TEST_CASE("empty strokes are passed over, wherever they are")
{
    const std::array strokes{StrokeView{nothing}, StrokeView{nothing},
                             StrokeView{zigzag},  StrokeView{nothing},
                             StrokeView{dot},     StrokeView{std::span<const Segment>{}}};
    const ArrayDrawing read = all_of(DrawingView{strokes});
    REQUIRE(read.size() == 2);
    CHECK(read[0].segments.size() == 2);
    CHECK(read[1].start == at(7, 7));
}

TEST_CASE("a drawing without strokes, or of empty ones, is the empty drawing")
{
    const std::array empty_strokes{StrokeView{nothing}};
    constexpr std::array strokes{StrokeView{zigzag}};
    const DrawingView drawing{strokes};
    for (const DrawingView empty : {DrawingView{}, DrawingView{empty_strokes}}) {
        CHECK(empty.strokes() == 0);
        CHECK(matched(empty, DrawingView{}).a.empty());
        const Matched both = matched(drawing, empty);
        REQUIRE(both.b.size() == 1);
        CHECK(both.a[0] == std::vector(zigzag.begin(), zigzag.end()));
        CHECK(both.b[0] == std::vector{at(4, 4), at(4, 4), at(4, 4)});
    }
}

TEST_CASE("a copy goes on from where the original stood, and both are independent")
{
    constexpr std::array strokes{StrokeView{zigzag}, StrokeView{dot}};
    DrawingView original{strokes};
    original.next_stroke();
    original.next_segment();
    DrawingView copy = original;
    CHECK(copy.next_segment().to == at(8, 0));
    CHECK(copy.next_stroke() == 0);
    CHECK(original.start() == at(0, 0));
    CHECK(original.next_segment().to == at(8, 0));
    CHECK(original.strokes() == 2);
}

TEST_CASE("the worked example of the design: abcdef and 123 against ABCDEFGH")
{
    constexpr std::array abcdef{at(0, 0), at(10, 0), at(20, 6), at(30, 0), at(40, 6), at(50, 0)};
    constexpr std::array digits{at(0, 20), at(10, 20), at(20, 30)};
    constexpr std::array capitals{at(0, 50),  at(4, 60),  at(8, 50),  at(12, 60),
                                  at(16, 50), at(20, 60), at(24, 50), at(28, 60)};
    const std::array two{StrokeView{abcdef}, StrokeView{digits}};
    const std::array one{StrokeView{capitals}};
    const Matched both = matched(DrawingView{two}, DrawingView{one});
    REQUIRE(both.a.size() == 2);
    CHECK(both.a[0] == std::vector(abcdef.begin(), abcdef.end()));
    CHECK(both.b[0] ==
          std::vector{at(0, 50), at(2, 55), at(4, 60), at(6, 55), at(8, 50), at(12, 60)}); // A 1 B 2 C D
    CHECK(both.a[1] == std::vector{at(0, 20), at(5, 20), at(10, 20), at(15, 25), at(20, 30)});
    CHECK(both.b[1] == std::vector(capitals.begin() + 3, capitals.end())); // D E F G H
    CHECK(!both.all_whole);
}

TEST_CASE("closed strokes of different numbers of points stay whole and closed")
{
    constexpr std::array triangle{at(0, 0), at(8, 0), at(4, 8), at(0, 0)};
    const std::array one{StrokeView{triangle}};
    const std::array other{StrokeView{leaf}};
    const Matched both = matched(DrawingView{one}, DrawingView{other});
    REQUIRE(both.a.size() == 1);
    CHECK(both.all_whole);
    CHECK(both.a[0].size() == 4);
    CHECK(both.a[0].front() == both.a[0].back());
    CHECK(both.b[0].front() == both.b[0].back());
}

TEST_CASE("a drawing in arrays morphs into another: equalized, tweened under laws, flattened")
{
    constexpr std::array from{StrokeView{zigzag}};
    constexpr std::array to{StrokeView{dot}};
    const auto x = progress(VelocityLaw::constant, Fraction::ratio(1, 2));
    const auto y = progress(VelocityLaw::accelerate, Fraction::ratio(2, 3)); // 1 - cos 60 degrees = 1/2
    std::vector<Point> points;
    EqualizedPair pair{DrawingView{from}, DrawingView{to}};
    while (const std::uint32_t segments = pair.next_stroke())
        for (std::uint32_t i = 0; i < segments; ++i) {
            const Pair<Segment> both = pair.next_segment();
            flatten(tween(both.a, both.b, x, y), 8, [&points](Point point) { points.push_back(point); });
        }
    REQUIRE(points.size() == 2);
    CHECK(points[0].x == pixels(5.5, 0).x);
    CHECK(points[1].x == pixels(7.5, 0).x);
    CHECK(std::abs((points[0].y - pixels(0, 7.5).y).raw()) <= 2);
    CHECK(std::abs((points[1].y - pixels(0, 3.5).y).raw()) <= 8);
}

TEST_CASE("random drawings are read as by the tests' own reader")
{
    std::mt19937 random{81};
    for (int round = 0; round < 300; ++round) {
        std::vector<std::vector<Point>> points(random() % 6);
        ArrayDrawing expected;
        std::vector<StrokeView> strokes;
        for (auto& stroke : points) {
            for (auto left = random() % 5; left > 0; --left)
                stroke.push_back(at(static_cast<int>(random() % 99), static_cast<int>(random() % 99)));
            strokes.emplace_back(stroke);
            if (!stroke.empty())
                expected.push_back(polyline(stroke));
        }
        const ArrayDrawing read = all_of(DrawingView{strokes});
        REQUIRE(read.size() == expected.size());
        for (std::size_t i = 0; i < read.size(); ++i) {
            CHECK(read[i].start == expected[i].start);
            CHECK(read[i].segments == expected[i].segments);
        }
    }
}

}

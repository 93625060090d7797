#include "core/pose/equalize.hpp"

#include "core/raster/outline/object_outline.hpp"
#include "core/raster/outline/stroke_outline.hpp"
#include "tests/core/array_drawing.hpp"
#include "tests/core/raster/coverage_picture.hpp"
#include "tests/rounds.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <random>

namespace kfast::test {
namespace {

/// One stroke of an equalized pair, as both sides yield it.
struct MatchedStroke {
    std::vector<Segment> a;
    std::vector<Segment> b;
    Pair<Point> hub;
    bool is_whole;
};

std::vector<MatchedStroke> equalized(const ArrayDrawing& a, const ArrayDrawing& b)
{
    std::vector<MatchedStroke> strokes;
    EqualizedPair pair{ArrayReader{a}, ArrayReader{b}};
    while (const std::uint32_t segments = pair.next_stroke()) {
        MatchedStroke stroke{{}, {}, {}, false};
        for (std::uint32_t i = 0; i < segments; ++i) {
            const Pair<Segment> both = pair.next_segment();
            stroke.a.push_back(both.a);
            stroke.b.push_back(both.b);
        }
        stroke.hub = pair.hub();
        stroke.is_whole = pair.is_whole();
        strokes.push_back(stroke);
    }
    return strokes;
}

std::vector<Point> vertices(const std::vector<Segment>& segments)
{
    std::vector<Point> points{segments.front().from};
    for (const Segment& segment : segments)
        points.push_back(segment.to);
    return points;
}

Point random_point(std::mt19937& random)
{
    const auto coordinate = [&random] { return Fixed::sixteenths(static_cast<int>(random() % 640) - 64); };
    const Fixed x = coordinate();
    return {x, coordinate()};
}

enum class Curves { none, some };

ArrayStroke random_stroke(std::mt19937& random, Curves curves)
{
    ArrayStroke stroke{random_point(random), {}};
    Point at = stroke.start;
    for (auto left = random() % (curves == Curves::some ? 4 : 7); left > 0; --left) {
        Segment segment{.from = at, .to = random_point(random)};
        if (curves == Curves::some && random() % 2 == 0) {
            segment.kind = Segment::Kind::cubic;
            segment.c1 = random_point(random);
            segment.c2 = random_point(random);
        }
        stroke.segments.push_back(segment);
        at = segment.to;
    }
    if (!stroke.segments.empty() && random() % 2 == 0)
        stroke.segments.push_back({.from = at, .to = stroke.start});
    return stroke;
}

ArrayDrawing random_drawing(std::mt19937& random, Curves curves)
{
    ArrayDrawing drawing(1 + random() % (curves == Curves::some ? 3 : 5));
    for (ArrayStroke& stroke : drawing)
        stroke = random_stroke(random, curves);
    return drawing;
}

bool is_closed(const ArrayStroke& stroke)
{
    return stroke.segments.empty() || stroke.segments.back().to == stroke.start;
}

/// Drawings are drawn so much larger than they are: corners that are dropped, and outlines that overlap
/// within a pixel, do not matter so much.
constexpr int larger = 8;

Fixed enlarged(Fixed length) { return Fixed::from_raw(length.raw() * larger); }
Point enlarged(Point point) { return {enlarged(point.x), enlarged(point.y)}; }

/// Feeds a stroke to an outline, but does not end it. Curves are divided so finely that it does not matter
/// where.
template <class Outline>
void trace(Outline& outline, const std::vector<Segment>& segments)
{
    outline.begin(enlarged(segments.front().from));
    for (const Segment& segment : segments) {
        const std::uint32_t pieces = segment.kind == Segment::Kind::cubic ? 256 : 1;
        for (std::uint32_t piece = 1; piece <= pieces; ++piece)
            outline.line_to(enlarged(point_at(segment, Fraction::ratio(piece, pieces))));
    }
}

constexpr int size = 40;

CoveragePicture new_picture() { return {size * larger, size * larger}; }

void draw(CoveragePicture& picture)
{
    REQUIRE_FALSE(picture.store().is_full());
    picture.draw();
}

/// Of a pixel of the drawing in its own size.
double level(const CoveragePicture& picture, int x, int y)
{
    int sum = 0;
    for (int i = 0; i < larger; ++i)
        for (int j = 0; j < larger; ++j)
            sum += picture.at(x * larger + i, y * larger + j);
    return sum / double{larger * larger};
}

double worst_difference(const CoveragePicture& one, const CoveragePicture& other)
{
    double worst = 0;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            worst = std::max(worst, std::abs(level(one, x, y) - level(other, x, y)));
    return worst;
}

void check_filled_alike(std::uint32_t seed, int count, Curves curves)
{
    std::mt19937 random{seed};
    for (int round = 0; round < count; ++round) {
        const ArrayDrawing a = random_drawing(random, curves);
        CoveragePicture original = new_picture();
        FillOutline plain{original.store()};
        for (const ArrayStroke& stroke : a) {
            if (stroke.segments.empty())
                continue;
            trace(plain, stroke.segments);
            plain.end(enlarged(stroke.start));
        }
        draw(original);
        CoveragePicture matched = new_picture();
        FillOutline parts{matched.store()};
        for (const MatchedStroke& stroke : equalized(a, random_drawing(random, curves))) {
            trace(parts, stroke.a);
            parts.end(enlarged(stroke.hub.a));
        }
        draw(matched);
        CHECK(worst_difference(original, matched) <= 4);
    }
}

/// Where a stroke was broken, a join becomes two caps, and their arcs have other pieces: each may be 1/24 px
/// off, along the diagonal of a pixel at most.
constexpr double levels_of_arcs = 2 * raster::full_coverage / 24.0 / larger * 3 / 4;

void check_stroked_alike(std::uint32_t seed, int count, Curves curves)
{
    std::mt19937 random{seed};
    for (int round = 0; round < count; ++round) {
        const ArrayDrawing a = random_drawing(random, curves);
        const Pen pen{.half_width =
                          enlarged(Fixed::from_raw(static_cast<std::int32_t>(16384 + random() % 250000))),
                      .cap = Cap::round,
                      .join = Join::round};
        CoveragePicture original = new_picture();
        StrokeOutline plain{original.store(), pen, 0};
        for (const ArrayStroke& stroke : a) {
            if (stroke.segments.empty())
                plain.begin(enlarged(stroke.start));
            else
                trace(plain, stroke.segments);
            plain.end(is_closed(stroke));
        }
        draw(original);
        CoveragePicture matched = new_picture();
        StrokeOutline parts{matched.store(), pen, 0};
        for (const MatchedStroke& stroke : equalized(a, random_drawing(random, curves))) {
            trace(parts, stroke.a);
            parts.end(stroke.is_whole && stroke.a.front().from == stroke.a.back().to);
        }
        draw(matched);
        CHECK(worst_difference(original, matched) <= levels_of_arcs + 1);
    }
}

const ArrayDrawing letters_and_digits{
    polyline({pixels(0, 0), pixels(10, 0), pixels(20, 5), pixels(30, 0), pixels(40, 5), pixels(50, 0)}),
    polyline({pixels(0, 20), pixels(10, 20), pixels(20, 30)})};
const ArrayDrawing capitals{polyline({pixels(0, 50), pixels(3, 60), pixels(6, 50), pixels(9, 60),
                                      pixels(12, 50), pixels(15, 60), pixels(18, 50), pixels(21, 60)})};

}

TEST_CASE("the original's worked example: abcdef and 123 against ABCDEFGH")
{
    const auto strokes = equalized(letters_and_digits, capitals);
    REQUIRE(strokes.size() == 2);
    SUBCASE("ABCD gains two points against abcdef, one on each of its first two segments")
    {
        CHECK(vertices(strokes[0].a) == vertices(letters_and_digits[0].segments));
        CHECK(vertices(strokes[0].b) == std::vector{pixels(0, 50), pixels(1.5, 55), pixels(3, 60),
                                                    pixels(4.5, 55), pixels(6, 50), pixels(9, 60)});
    }
    SUBCASE("123 becomes 1 1' 2 2' 3 against DEFGH")
    {
        CHECK(vertices(strokes[1].a) ==
              std::vector{pixels(0, 20), pixels(5, 20), pixels(10, 20), pixels(15, 25), pixels(20, 30)});
        CHECK(vertices(strokes[1].b) ==
              std::vector{pixels(9, 60), pixels(12, 50), pixels(15, 60), pixels(18, 50), pixels(21, 60)});
    }
    SUBCASE("the parts of the broken stroke are closed over its first point, whole strokes over their own")
    {
        CHECK(strokes[1].hub.b == pixels(0, 50));
        CHECK(strokes[1].hub.a == pixels(0, 20));
        CHECK(!strokes[0].is_whole);
        CHECK(!strokes[1].is_whole);
    }
}

TEST_CASE("the order of the two drawings does not matter")
{
    std::mt19937 random{11};
    for (int round = 0; round < 200; ++round) {
        const ArrayDrawing a = random_drawing(random, Curves::some);
        const ArrayDrawing b = random_drawing(random, Curves::some);
        const auto forwards = equalized(a, b);
        const auto backwards = equalized(b, a);
        REQUIRE(forwards.size() == backwards.size());
        for (std::size_t i = 0; i < forwards.size(); ++i) {
            CHECK(forwards[i].a == backwards[i].b);
            CHECK(forwards[i].b == backwards[i].a);
        }
    }
}

TEST_CASE("five strokes against two: the first of the two is broken into three parts, the second into two")
{
    const auto dot = [](double x) { return ArrayStroke{pixels(x, 0), {}}; };
    const ArrayDrawing five{dot(0), dot(1), dot(2), dot(3), dot(4)};
    const ArrayDrawing two{
        polyline({pixels(0, 0), pixels(1, 0), pixels(2, 0), pixels(3, 0), pixels(4, 0), pixels(5, 0)}),
        polyline({pixels(0, 9), pixels(1, 9), pixels(2, 9), pixels(3, 9)})};
    const auto strokes = equalized(five, two);
    REQUIRE(strokes.size() == 5);
    CHECK(vertices(strokes[0].b) == std::vector{pixels(0, 0), pixels(1, 0)});
    CHECK(vertices(strokes[1].b) == std::vector{pixels(1, 0), pixels(2, 0), pixels(3, 0)});
    CHECK(vertices(strokes[2].b) == std::vector{pixels(3, 0), pixels(4, 0), pixels(5, 0)});
    CHECK(vertices(strokes[3].b) == std::vector{pixels(0, 9), pixels(1, 9)});
    CHECK(vertices(strokes[4].b) == std::vector{pixels(1, 9), pixels(2, 9), pixels(3, 9)});
    for (const Segment& segment : strokes[2].a)
        CHECK(segment == still_segment(pixels(2, 0)));
}

TEST_CASE("a stroke with fewer segments than parts is divided first, the first segments more often")
{
    const auto dot = [](double x) { return ArrayStroke{pixels(x, 0), {}}; };
    const auto strokes = equalized({dot(0), dot(1), dot(2), dot(3), dot(4)},
                                   {polyline({pixels(0, 0), pixels(3, 0), pixels(5, 0)})});
    REQUIRE(strokes.size() == 5);
    for (std::size_t i = 0; i < 5; ++i)
        CHECK(std::abs((strokes[i].b.front().to.x - pixels(static_cast<double>(i) + 1, 0).x).raw()) <= 1);
    CHECK(strokes[2].b.front().to == pixels(3, 0));
}

TEST_CASE("an empty drawing is its partner drawn together to the centres of its strokes")
{
    const ArrayDrawing square_and_dot{
        polyline({pixels(2, 2), pixels(6, 2), pixels(6, 10), pixels(2, 10), pixels(2, 2)}),
        {pixels(20, 30), {}}};
    const auto strokes = equalized({}, square_and_dot);
    REQUIRE(strokes.size() == 2);
    CHECK(strokes[0].b == square_and_dot[0].segments);
    for (const Segment& segment : strokes[0].a)
        CHECK(segment == still_segment(pixels(4, 6)));
    CHECK(strokes[0].is_whole);
    CHECK(strokes[1].a.front() == still_segment(pixels(20, 30)));
    CHECK(strokes[0].hub.a == pixels(4, 6));
    const auto turned = equalized(square_and_dot, {});
    REQUIRE(turned.size() == 2);
    CHECK(turned[0].a == square_and_dot[0].segments);
    for (const Segment& segment : turned[0].b)
        CHECK(segment == still_segment(pixels(4, 6)));
    CHECK(turned[0].hub.b == pixels(4, 6));
    CHECK(turned[1].b.front() == still_segment(pixels(20, 30)));
    const ArrayDrawing nothing;
    EqualizedPair pair{ArrayReader{square_and_dot}, ArrayReader{nothing}};
    pair.next_stroke();
    pair.next_segment();
    CHECK_FALSE(pair.is_plain());
    CHECK(equalized({}, {}).empty());
}

TEST_CASE(
    "random pairs: both sides go through their own vertices in order, and parts share their break points")
{
    std::mt19937 random{12};
    for (int round = 0; round < 500; ++round) {
        const ArrayDrawing a = random_drawing(random, Curves::some);
        const ArrayDrawing b = random_drawing(random, Curves::some);
        const auto strokes = equalized(a, b);
        REQUIRE(strokes.size() == std::max(a.size(), b.size()));
        const std::uint32_t parts = static_cast<std::uint32_t>(strokes.size());
        std::size_t stroke = 0;
        for (std::size_t own = 0; own < a.size(); ++own) {
            std::vector<Segment> pieces;
            for (std::uint32_t part = 0; part < Distribution{parts, static_cast<std::uint32_t>(a.size())}.at(
                                                    static_cast<std::uint32_t>(own));
                 ++part, ++stroke) {
                REQUIRE(strokes[stroke].a.size() == strokes[stroke].b.size());
                CHECK(strokes[stroke].hub.a == a[own].start);
                pieces.insert(pieces.end(), strokes[stroke].a.begin(), strokes[stroke].a.end());
            }
            CHECK(pieces.front().from == a[own].start);
            std::size_t vertex = 0;
            for (std::size_t i = 0; i < pieces.size(); ++i) {
                if (i > 0)
                    CHECK(pieces[i].from == pieces[i - 1].to);
                if (vertex < a[own].segments.size() && pieces[i].to == a[own].segments[vertex].to)
                    ++vertex;
            }
            CHECK(vertex == a[own].segments.size());
        }
    }
}

TEST_CASE("a drawing beside itself is read once, and every segment is paired with itself")
{
    std::mt19937 random{17};
    for (int round = 0; round < 100; ++round) {
        const ArrayDrawing a = random_drawing(random, Curves::some);
        EqualizedPair alone{ArrayReader{a}};
        EqualizedPair twice{ArrayReader{a}, ArrayReader{a}};
        std::uint32_t segments = 0;
        do {
            segments = alone.next_stroke();
            REQUIRE(segments == twice.next_stroke());
            for (std::uint32_t i = 0; i < segments; ++i) {
                const Pair<Segment>& both = alone.next_segment();
                const Pair<Segment>& expected = twice.next_segment();
                CHECK((both.a == expected.a && both.b == expected.b));
            }
            if (segments != 0)
                CHECK((alone.is_whole() && alone.hub().a == twice.hub().a && alone.hub().b == twice.hub().b));
        } while (segments != 0);
    }
    const ArrayDrawing nothing;
    CHECK(EqualizedPair{ArrayReader{nothing}}.next_stroke() == 0);
}

TEST_CASE("an equalized drawing, filled, is the original picture to within four levels")
{
    check_filled_alike(13, rounds(300), Curves::none);
    check_filled_alike(14, rounds(20), Curves::some);
}

TEST_CASE("an equalized drawing, stroked with round caps and joins, is the original picture but for its arcs")
{
    check_stroked_alike(15, rounds(300), Curves::none);
    check_stroked_alike(16, rounds(20), Curves::some);
}

}

#include "core/math/stroke_trimmer.hpp"

#include "tests/core/math/cut_strokes.hpp"
#include "tests/rounds.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <doctest/doctest.h>
#include <random>
#include <vector>

namespace kfast::test {
namespace {

constexpr std::int32_t share(double part) { return static_cast<std::int32_t>(part * Trim::whole); }

Trim trim_of(double from, double to, double offset = 0, TrimMode mode = TrimMode::each)
{
    return Trim::between(share(from), share(to), share(offset), mode);
}

const std::vector square{pixels(0, 0), pixels(10, 0), pixels(10, 10), pixels(0, 10), pixels(0, 0)};

}

TEST_CASE("a trim goes from the lesser share to the larger, and around")
{
    CHECK(Trim{}.is_whole());
    CHECK(trim_of(0, 1).is_whole());
    CHECK(trim_of(0.25, 0.25).is_empty());
    const Trim swapped = trim_of(0.75, 0.25);
    CHECK(swapped.begin == Trim::whole / 4);
    CHECK(swapped.share == Trim::whole / 2);
    CHECK(trim_of(0.5, 1, 0.75).begin == Trim::whole / 4);
    CHECK(trim_of(0.5, 1, -0.75).begin == Trim::whole / 4 * 3);
    CHECK(trim_of(-1, 2).is_whole());
}

TEST_CASE("an open stroke is cut where its length says")
{
    const TestStroke stroke = lines({pixels(0, 0), pixels(10, 0), pixels(10, 30)});
    const auto pieces = trimmed({stroke}, trim_of(0.125, 0.5));
    REQUIRE(pieces.size() == 1);
    CHECK(pieces[0].from == pixels(5, 0));
    CHECK(apart(pieces[0].to(), {10, 10}) < 0.001);
    CHECK(pieces[0].segments.size() == 2);
    CHECK(pieces[0].end == PieceEnd::open);
    CHECK(pieces[0].hub == pieces[0].from);
    CHECK(trimmed({stroke}, trim_of(0.5, 0.5)).empty());
}

TEST_CASE("a trim across the end of an open stroke leaves two pieces")
{
    const auto pieces = trimmed({lines({pixels(0, 0), pixels(40, 0)})}, trim_of(0, 0.5, 0.75));
    REQUIRE(pieces.size() == 2);
    CHECK(pieces[0].to() == pixels(10, 0));
    CHECK(pieces[1].from == pixels(30, 0));
    CHECK(pieces[0].end == PieceEnd::open);
    CHECK(pieces[1].end == PieceEnd::open);
}

TEST_CASE("a trim across the seam of a closed stroke leaves two pieces that meet")
{
    const auto pieces = trimmed({lines(square, true)}, trim_of(0, 0.5, 0.875));
    REQUIRE(pieces.size() == 2);
    CHECK(pieces[0].end == PieceEnd::after_seam);
    CHECK(pieces[0].from == pixels(0, 0));
    CHECK(pieces[0].to() == pixels(10, 5));
    CHECK(pieces[1].end == PieceEnd::at_seam);
    CHECK(pieces[1].from == pixels(0, 5));
    CHECK(pieces[1].to() == pixels(0, 0));
    CHECK(pieces[1].hub == pixels(10, 5)); // closes the fill of both
}

TEST_CASE("strokes are trimmed by themselves or together")
{
    const std::vector strokes{lines({pixels(0, 0), pixels(30, 0)}), lines({pixels(0, 9), pixels(10, 9)})};
    const auto each = trimmed(strokes, trim_of(0, 0.5));
    REQUIRE(each.size() == 2);
    CHECK(each[0].to() == pixels(15, 0));
    CHECK(each[1].to() == pixels(5, 9));
    const auto together = trimmed(strokes, trim_of(0.5, 0.875, 0, TrimMode::together));
    REQUIRE(together.size() == 2);
    CHECK(apart(together[0].from, {20, 0}) < 0.001);
    CHECK(together[0].to() == pixels(30, 0));
    CHECK(together[1].to() == pixels(5, 9));
    const auto whole = trimmed(strokes, trim_of(0, 0.75, 0, TrimMode::together));
    REQUIRE(whole.size() == 1);
    CHECK(whole[0].to() == pixels(30, 0));
}

TEST_CASE("a closed stroke that is wholly within the window stays closed")
{
    const std::vector strokes{lines(square, true), lines({pixels(0, 20), pixels(40, 20)})};
    const auto pieces = trimmed(strokes, trim_of(0, 0.75, 0, TrimMode::together));
    REQUIRE(pieces.size() == 2);
    CHECK(pieces[0].end == PieceEnd::closed);
    CHECK(pieces[0].segments.size() == 4);
    CHECK(pieces[1].to() == pixels(20, 20));
}

TEST_CASE("any number of strokes is trimmed")
{
    std::vector<TestStroke> strokes;
    strokes.reserve(50);
    for (int i = 0; i < 50; ++i)
        strokes.push_back(lines({pixels(0, i), pixels(i + 1, i)}));
    const auto each = trimmed(strokes, trim_of(0, 0.5));
    REQUIRE(each.size() == 50);
    for (std::size_t i = 0; i < 50; ++i)
        CHECK(apart(each[i].to(), {(static_cast<double>(i) + 1) / 2, static_cast<double>(i)}) < 0.001);
    const auto together = trimmed(strokes, trim_of(0.5, 1, 0, TrimMode::together)); // of 1275 px
    CHECK(together.size() == 15);
    CHECK(together[0].from.y == Fixed::pixels(35));
    CHECK(std::abs(together[0].from.x.raw() / 65536.0 - 7.5) < 0.01);
}

TEST_CASE("a pie is trimmed by its angle")
{
    const auto quarter = [](Point from, Point c1, Point c2, Point to) {
        return Segment{Segment::Kind::cubic, from, c1, c2, to};
    };
    // A half circle of radius 100 about (100, 100), from three o'clock.
    const Point right = pixels(200, 100), bottom = pixels(100, 200), left = pixels(0, 100),
                centre = pixels(100, 100);
    const Fixed near = Fixed::from_raw(10173055), far = Fixed::from_raw(2934145); // 155.23, 44.77
    const TestStroke pie{centre,
                         {{.from = centre, .to = right},
                          quarter(right, {right.x, near}, {near, bottom.y}, bottom),
                          quarter(bottom, {far, bottom.y}, {left.x, near}, left),
                          {.from = left, .to = centre}},
                         true};
    const auto pieces = trimmed({pie}, trim_of(0, 0.25, 0, TrimMode::sector));
    REQUIRE(pieces.size() == 1);
    CHECK(pieces[0].end == PieceEnd::closed);
    CHECK(pieces[0].from == centre);
    REQUIRE(pieces[0].segments.size() == 3);
    CHECK(pieces[0].segments[0].to == right);
    CHECK(apart(pieces[0].segments[1].to, {100 + 100 * std::sqrt(0.5), 100 + 100 * std::sqrt(0.5)}) < 0.05);
    CHECK(pieces[0].to() == centre);
    const auto around = trimmed({pie}, trim_of(0.5, 1, 0.25, TrimMode::sector));
    CHECK(around.size() == 2); // the curves end elsewhere than they began
}

TEST_CASE("a whole pie turns across its seam as one piece")
{
    TestStroke pie{pixels(0, 0), {{.from = pixels(0, 0), .to = pixels(10, 0)}}, true};
    const std::vector corners{pixels(10, 0), pixels(0, 10), pixels(-10, 0), pixels(0, -10), pixels(10, 0)};
    for (std::size_t i = 0; i < 4; ++i)
        pie.segments.push_back(
            {Segment::Kind::cubic, corners[i], corners[i], corners[i + 1], corners[i + 1]});
    pie.segments.push_back({.from = pixels(10, 0), .to = pixels(0, 0)});
    const auto pieces = trimmed({pie}, trim_of(0, 0.25, 0.875, TrimMode::sector));
    REQUIRE(pieces.size() == 1);
    CHECK(pieces[0].end == PieceEnd::closed);
    CHECK(pieces[0].from == pixels(10, 0));
    CHECK(pieces[0].to() == pixels(10, 0));
    CHECK(std::ranges::count(pieces[0].segments, pixels(0, 0), &Segment::to) == 1);
}

TEST_CASE("a dot is drawn or not")
{
    const TestStroke dot{pixels(3, 4), {still_segment(pixels(3, 4))}};
    CHECK(trimmed({dot}, trim_of(0.25, 0.5)).size() == 1);
    const std::vector strokes{lines({pixels(0, 0), pixels(10, 0)}), dot,
                              lines({pixels(0, 9), pixels(10, 9)})};
    CHECK(trimmed(strokes, trim_of(0.25, 0.75, 0, TrimMode::together)).size() == 3);
    CHECK(trimmed(strokes, trim_of(0.75, 1, 0, TrimMode::together)).size() == 1);
}

TEST_CASE("pieces are placed, and shares are those before")
{
    const Affine stretched{.xx = 4 * Fixed::one};
    const auto pieces =
        trimmed({lines({pixels(0, 0), pixels(10, 0), pixels(10, 10)})}, trim_of(0.25, 0.75), stretched);
    REQUIRE(pieces.size() == 1);
    CHECK(pieces[0].from == pixels(20, 0));
    CHECK(pieces[0].to() == pixels(40, 5));
}

TEST_CASE("cuts are within 1/16 px of where the length of the curves says")
{
    std::mt19937 random{1};
    double worst = 0;
    for (int i = rounds(2000); i > 0; --i) {
        const TestStroke stroke = random_stroke(random);
        const ExactCurve exact{stroke.segments};
        const auto part = [&random] { return static_cast<double>(random() % 1000) / 1000; };
        const double from = 0.9 * part();
        const double to = from + 0.01 + (0.98 - from) * part();
        const auto pieces = trimmed({stroke}, trim_of(from, to));
        REQUIRE(pieces.size() == 1);
        worst = std::max({worst, apart(pieces[0].from, exact.at(from)), apart(pieces[0].to(), exact.at(to))});
    }
    CHECK(worst < 1 / 16.0);
}

TEST_CASE("absurd lengths stay in order")
{
    const Point far = pixels(16383, 16383);
    std::vector<Point> points;
    points.reserve(200);
    for (int i = 0; i < 200; ++i)
        points.push_back(i % 2 == 0 ? -far : far);
    for (const TrimMode mode : {TrimMode::each, TrimMode::together, TrimMode::sector})
        for (const double from : {0.0, 0.1, 0.5})
            CHECK(trimmed({lines(points), lines(points)}, trim_of(from, 0.9, 0.3, mode)).size() <= 4);
}

}

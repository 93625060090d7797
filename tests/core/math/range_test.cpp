#include "core/pose/equalize.hpp"
#include "core/scene/drawing_view.hpp"
#include "core/time/velocity_law.hpp"
#include "tests/core/array_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <limits>
#include <random>
#include <vector>

/// The largest values that the contracts of the public headers allow.
namespace kfast::test {
namespace {

constexpr std::int32_t max = std::numeric_limits<std::int32_t>::max();

/// Coordinates less than 32768 px apart, lying anywhere in the range of Fixed.
class WideBox {
public:
    explicit WideBox(std::uint32_t seed) : random_{seed} {}

    void move() { low_ = std::numeric_limits<std::int32_t>::min() + below(std::int64_t{1} << 32); }

    Fixed coordinate()
    {
        const std::int64_t low = std::min<std::int64_t>(low_, 0);
        switch (random_() % 4) {
        case 0:
            return Fixed::from_raw(static_cast<std::int32_t>(low));
        case 1:
            return Fixed::from_raw(static_cast<std::int32_t>(low + max));
        default:
            return Fixed::from_raw(static_cast<std::int32_t>(low + below(std::int64_t{max} + 1)));
        }
    }

    Point point()
    {
        const Fixed x = coordinate();
        return {x, coordinate()};
    }

    Segment cubic()
    {
        Segment segment{.kind = Segment::Kind::cubic};
        for (Point* at : {&segment.from, &segment.c1, &segment.c2, &segment.to})
            *at = point();
        return segment;
    }

    Fraction share() { return {static_cast<std::uint32_t>(random_() % (Fraction::one + 1))}; }

private:
    std::int64_t below(std::int64_t end) { return static_cast<std::int64_t>(random_()) % end; }

    std::mt19937 random_;
    std::int64_t low_ = -(std::int64_t{1} << 30);
};

double off(Fixed value, double exact) { return std::abs(value.raw() - exact); }

double between(Fixed a, Fixed b, double share)
{
    return a.raw() + (static_cast<double>(b.raw()) - a.raw()) * share;
}

double on_curve(const Segment& cubic, double t)
{
    const double s = 1 - t;
    return s * s * s * cubic.from.x.raw() + 3 * s * s * t * cubic.c1.x.raw() +
           3 * s * t * t * cubic.c2.x.raw() + t * t * t * cubic.to.x.raw();
}

}

TEST_CASE("tweening is rounded once and exact at both ends when coordinates are 32767.99 px apart")
{
    WideBox box{91};
    for (int round = 0; round < 20'000; ++round) {
        box.move();
        const Segment a = box.cubic();
        const Segment b = box.cubic();
        const auto eased = progress(VelocityLaw::constant, box.share());
        const Segment live = tween(a, b, eased, eased);
        for (const auto at : {&Segment::from, &Segment::c1, &Segment::c2, &Segment::to}) {
            REQUIRE(off((live.*at).x, between((a.*at).x, (b.*at).x, eased.raw / 65536.0)) <= 0.5);
            REQUIRE(off((live.*at).y, between((a.*at).y, (b.*at).y, eased.raw / 65536.0)) <= 0.5);
        }
        REQUIRE(tween(a, b, {0}, {0}) == a);
        REQUIRE(tween(a, b, {Fraction::one}, {Fraction::one}) == b);
    }
}

TEST_CASE("coordinates within 4095 px may be tweened as far beyond the keys as laws lead, and then divided")
{
    std::mt19937 random{94};
    const auto coordinate = [&random] {
        constexpr std::int32_t border = 4095 * Fixed::one;
        const auto any = static_cast<std::int32_t>(random() % (2U * border + 1)) - border;
        return Fixed::from_raw(random() % 2 == 0 ? any : (any < 0 ? -border : border));
    };
    const auto cubic = [&coordinate] {
        Segment segment{.kind = Segment::Kind::cubic};
        for (Point* at : {&segment.from, &segment.c1, &segment.c2, &segment.to})
            at->x = coordinate();
        return segment;
    };
    constexpr std::int32_t beyond = 3 * Progress::one / 2;
    for (int round = 0; round < 20'000; ++round) {
        const Segment a = cubic();
        const Segment b = cubic();
        const Progress eased{round % 2 == 0 ? -beyond : Progress::one + beyond};
        const Segment live = tween(a, b, eased, eased);
        for (const auto at : {&Segment::from, &Segment::c1, &Segment::c2, &Segment::to})
            REQUIRE(off((live.*at).x, between((a.*at).x, (b.*at).x, eased.raw / 65536.0)) <= 0.5);
        const Fraction share{static_cast<std::uint32_t>(random() % (Fraction::one + 1))};
        REQUIRE(off(point_at(live, share).x, on_curve(live, share.raw / 65536.0)) <= 2);
    }
}

TEST_CASE("points and stretches of curves are within two units when coordinates are 32767.99 px apart")
{
    WideBox box{92};
    for (int round = 0; round < 20'000; ++round) {
        box.move();
        const Segment cubic = box.cubic();
        const Fraction one = box.share();
        const Fraction other = box.share();
        const auto [begin, end] = std::minmax(one, other);
        const Segment part = subsegment(cubic, begin, end);
        REQUIRE(off(part.from.x, on_curve(cubic, begin.raw / 65536.0)) <= 2);
        REQUIRE(off(part.to.x, on_curve(cubic, end.raw / 65536.0)) <= 2);
        REQUIRE(off(point_at(cubic, one).x, on_curve(cubic, one.raw / 65536.0)) <= 2);
    }
}

TEST_CASE("the control points of a line as a curve are off the thirds by 1/65536 of it at most")
{
    const Segment line{.from = {Fixed::from_raw(-(max / 2)), {}}, .to = {Fixed::from_raw(max / 2), {}}};
    const Segment live = as_cubic(line);
    CHECK(live.kind == Segment::Kind::cubic);
    CHECK(off(live.c1.x, -max / 6.0) <= max / 65536.0);
    CHECK(off(live.c2.x, max / 6.0) <= max / 65536.0);
}

TEST_CASE("65535 strokes break one stroke of 65535 segments into its segments")
{
    std::vector<Point> points;
    for (std::int32_t i = 0; i <= 65535; ++i)
        points.push_back({Fixed::from_raw(i * 7), {}});
    const std::vector<StrokeView> one{StrokeView{points}};
    const std::vector<StrokeView> dots(65535, StrokeView{std::span{points}.first(1)});
    EqualizedPair pair{DrawingView{one}, DrawingView{dots}};
    for (std::size_t i = 0; i < 65535; ++i) {
        REQUIRE(pair.next_stroke() == 1);
        const Segment own = pair.next_segment().a;
        REQUIRE(own.from == points[i]);
        REQUIRE(own.to == points[i + 1]);
    }
    CHECK(pair.next_stroke() == 0);
}

TEST_CASE("one segment is divided for 65535 strokes, the last of which has 65535 segments")
{
    const std::vector<Point> ends{{}, {Fixed::pixels(32767), {}}};
    const std::vector<Point> many(65536);
    const std::vector<StrokeView> one{StrokeView{ends}};
    std::vector<StrokeView> strokes(65535, StrokeView{std::span{many}.first(1)});
    strokes.back() = StrokeView{many};
    EqualizedPair pair{DrawingView{one}, DrawingView{strokes}};
    Point at;
    while (const std::uint32_t segments = pair.next_stroke())
        for (std::uint32_t i = 0; i < segments; ++i) {
            const Segment own = pair.next_segment().a;
            REQUIRE(own.from == at);
            REQUIRE(own.to.x >= at.x);
            at = own.to;
        }
    CHECK(at == ends[1]);
}

}

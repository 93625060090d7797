#include "core/math/segment.hpp"

namespace kfast {
namespace {

/// The polar form of a cubic: blossom(t, t, t) is the point at t.
Point blossom(const Segment& cubic, Fraction r, Fraction s, Fraction t)
{
    const Point a = lerp(cubic.from, cubic.c1, r);
    const Point b = lerp(cubic.c1, cubic.c2, r);
    const Point c = lerp(cubic.c2, cubic.to, r);
    return lerp(lerp(a, b, s), lerp(b, c, s), t);
}

}

Segment as_cubic(const Segment& segment)
{
    if (segment.kind == Segment::Kind::cubic)
        return segment;
    constexpr Fraction third = Fraction::ratio(1, 3);
    return {.kind = Segment::Kind::cubic,
            .from = segment.from,
            .c1 = lerp(segment.from, segment.to, third),
            .c2 = lerp(segment.to, segment.from, third),
            .to = segment.to};
}

Segment rounded_to_grid(const Segment& segment)
{
    const auto rounded = [](Point point) {
        constexpr std::int32_t step = Fixed::one / 64;
        const auto of = [](Fixed at) { return Fixed::from_raw((at.raw() + step / 2) & -step); };
        return Point{of(point.x), of(point.y)};
    };
    return {segment.kind, rounded(segment.from), rounded(segment.c1), rounded(segment.c2),
            rounded(segment.to)};
}

Point point_at(const Segment& segment, Fraction fraction)
{
    if (segment.kind == Segment::Kind::line)
        return lerp(segment.from, segment.to, fraction);
    return blossom(segment, fraction, fraction, fraction);
}

Segment stretch(const Segment& whole, Fraction begin, Fraction end)
{
    Segment part{.kind = whole.kind, .from = point_at(whole, begin), .to = point_at(whole, end)};
    if (whole.kind == Segment::Kind::cubic) {
        part.c1 = blossom(whole, begin, begin, end);
        part.c2 = blossom(whole, begin, end, end);
    }
    return part;
}

Segment tween(const Segment& a, const Segment& b, Progress x, Progress y)
{
    Segment live{.kind = a.kind, .from = lerp(a.from, b.from, x, y), .to = lerp(a.to, b.to, x, y)};
    if (a.kind == Segment::Kind::cubic) {
        live.c1 = lerp(a.c1, b.c1, x, y);
        live.c2 = lerp(a.c2, b.c2, x, y);
    }
    return live;
}

}

#include "core/math/flatten.hpp"

#include "core/bytes/expects.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>

namespace kfast {

namespace {

/// The polar form of a cubic: blossom(t, t, t) is the point at t.
[[gnu::cold]] Point blossom(const Segment& cubic, Fraction r, Fraction s, Fraction t)
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

Segment subsegment(const Segment& whole, Fraction begin, Fraction end)
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

namespace {

constexpr int spare_bits = 2; ///< the sum of four coordinates has these more

/// |a - 2 b + c| in 1/16384 px, at most 1/8 too much.
std::int32_t bend(Point a, Point b, Point c)
{
    const auto of = [](Fixed from, Fixed by, Fixed to) {
        return ((from - by).raw() >> spare_bits) + ((to - by).raw() >> spare_bits);
    };
    return rough_length(of(a.x, b.x, c.x), of(a.y, b.y, c.y));
}

/// Powers of 1 / pieces, each shifted up by `shift` as often as its exponent says: 1/2 … 1 in Q16.
struct StepLength {
    std::uint32_t first;
    std::uint32_t square;
    std::uint32_t cube;
    int shift;
};

constexpr auto step_lengths = [] {
    std::array<StepLength, max_steps + 1> table{};
    for (std::uint32_t n = 1; n <= max_steps; ++n) {
        int shift = 0;
        while (2U << shift <= n)
            ++shift;
        const auto power = [shift](std::uint32_t divisor, int exponent) {
            return ((Fraction::one << exponent * shift) + divisor / 2) / divisor;
        };
        table[n] = {power(n, 1), power(n * n, 2), power(n * n * n, 3), shift};
    }
    return table;
}();

constexpr int finest_unit_bits = 10;

/// The bits of the largest of these lengths, in 1/4096 px.
std::uint32_t spread(Fixed c1, Fixed c2, Fixed to)
{
    constexpr int bits = 4;
    const std::int32_t p1 = c1.raw() >> bits;
    const std::int32_t p2 = c2.raw() >> bits;
    const std::int32_t p3 = to.raw() >> bits;
    const auto length = [](std::int32_t value) { return static_cast<std::uint32_t>(std::abs(value)); };
    return length(3 * p1) | length(3 * (p2 - 2 * p1)) | length(3 * (p1 - 2 * p2 + p3)) | length(p2) |
           length(p3);
}

/// A unit of 2^-bits px in which no step of CubicSteps::set() needs more than 32 bits; down to -4. `all` has
/// the bits of spread() along x and along y.
int unit_bits_for(std::uint32_t all)
{
    int bits = finest_unit_bits;
    for (std::uint32_t limit = 31U << 12; all >= limit; limit <<= 1) // and a pixel for rounding
        --bits;
    return bits;
}

/// value * factor / 2^bits, rounded to nearest.
std::int32_t divided(std::int32_t value, std::uint32_t factor, int bits)
{
    return (value * static_cast<std::int32_t>(factor) + (1 << bits >> 1)) >> bits;
}

}

CubicSteps::CubicSteps(const Segment& cubic, int pieces) : from_{cubic.from}
{
    expects(cubic.kind == Segment::Kind::cubic && pieces >= 2 && pieces <= max_steps);
    // Not as points, which would be copied by a function.
    const Fixed x1 = cubic.c1.x - cubic.from.x;
    const Fixed x2 = cubic.c2.x - cubic.from.x;
    const Fixed x3 = cubic.to.x - cubic.from.x;
    const Fixed y1 = cubic.c1.y - cubic.from.y;
    const Fixed y2 = cubic.c2.y - cubic.from.y;
    const Fixed y3 = cubic.to.y - cubic.from.y;
    shift_ = unit_bits_for(spread(x1, x2, x3) | spread(y1, y2, y3)) + result_bits;
    set(x_, x1, x2, x3, pieces);
    set(y_, y1, y2, y3, pieces);
}

/// Sets the axis to the beginning of the curve to `to` with the control points `c1` and `c2`.
void CubicSteps::set(Axis& axis, Fixed c1, Fixed c2, Fixed to, int pieces) const
{
    const int dropped = 15 + result_bits - shift_;
    const auto units = [dropped](Fixed value) { return ((value.raw() >> dropped) + 1) >> 1; };
    const std::int32_t p1 = units(c1);
    const std::int32_t p2 = units(c2);
    const std::int32_t bend = p2 - 2 * p1;
    const std::int32_t last_bend = p1 - 2 * p2 + units(to);
    const StepLength& h = step_lengths[static_cast<std::size_t>(pieces)];
    const std::int32_t slope = divided(3 * p1, h.first, h.shift);
    const std::int32_t square = divided(3 * bend, h.square, 2 * h.shift);
    const std::int32_t cube = divided(last_bend - bend, h.cube, 3 * h.shift);
    const std::int32_t twelfth = (square >> 3) + (square >> 5) + (square >> 7); // of 2 B h^2
    const std::int32_t third = 6 * cube;
    axis = {.value = static_cast<std::uint32_t>((1 << shift_ >> 1) - twelfth),
            .first = static_cast<std::uint32_t>(slope + square + cube - (cube >> 1)),
            .second = static_cast<std::uint32_t>(2 * square + third),
            .third = static_cast<std::uint32_t>(third)};
}

int pieces_for(const Segment& segment)
{
    if (segment.kind == Segment::Kind::line)
        return 1;
    const std::int32_t bent =
        std::max(bend(segment.from, segment.c1, segment.c2), bend(segment.c1, segment.c2, segment.to));
    constexpr std::int32_t limit = (flatness.raw() * 4 / 3) >> spare_bits;
    int pieces = 1;
    while (pieces < max_pieces && pieces * pieces * limit < bent)
        pieces = pieces < max_steps ? pieces + 1 : 2 * pieces;
    return pieces;
}

}

#pragma once

#include "core/segment.hpp"

namespace kfast {

/// Calls line_to(point) for the ends of the straight pieces that stand for `segment`: one for a line,
/// 2^pieces_log2 of equal parameter length for a curve (pieces_log2 is 0 … 6). The points lie within
/// 1/65536 px of the curve; the last one is exact.
template <class LineTo>
void flatten(const Segment& segment, int pieces_log2, LineTo line_to);

/// One coordinate of a cubic as a polynomial: ((a t + b) t + c) t + d.
class CubicPolynomial {
public:
    constexpr CubicPolynomial(Fixed from, Fixed c1, Fixed c2, Fixed to)
        : a_{std::int64_t{to.raw()} - from.raw() + 3 * (std::int64_t{c1.raw()} - c2.raw())},
          b_{3 * (std::int64_t{from.raw()} - 2 * std::int64_t{c1.raw()} + c2.raw())},
          c_{3 * (std::int64_t{c1.raw()} - from.raw())}, d_{from.raw()}
    {
    }

    /// At t = step / 2^steps_log2, rounded to nearest, for steps_log2 of 1 … 6.
    constexpr Fixed at(std::int32_t step, int steps_log2) const
    {
        const std::int64_t steps = std::int64_t{1} << steps_log2;
        const std::int64_t sum = ((a_ * step + b_ * steps) * step + c_ * steps * steps) * step;
        const int shift = 3 * steps_log2;
        return Fixed::from_raw(
            static_cast<std::int32_t>(d_ + ((sum + (std::int64_t{1} << (shift - 1))) >> shift)));
    }

private:
    std::int64_t a_, b_, c_, d_;
};

template <class LineTo>
void flatten(const Segment& segment, int pieces_log2, LineTo line_to)
{
    if (segment.kind == Segment::Kind::cubic) {
        const CubicPolynomial x{segment.from.x, segment.c1.x, segment.c2.x, segment.to.x};
        const CubicPolynomial y{segment.from.y, segment.c1.y, segment.c2.y, segment.to.y};
        for (std::int32_t step = 1; step < 1 << pieces_log2; ++step)
            line_to(Point{x.at(step, pieces_log2), y.at(step, pieces_log2)});
    }
    line_to(segment.to);
}

}

#pragma once

#include "core/segment.hpp"

#include <cstdint>
#include <cstdlib>
#include <limits>

namespace kfast {

/// How far from a curve the straight pieces may lie that stand for it.
inline constexpr Fixed flatness = Fixed::from_raw(Fixed::one / 24);

inline constexpr int most_halvings = 8;

/// One coordinate of a cubic at steps of equal parameter length, each rounded to nearest, halves up. With n
/// steps, n^3 times the polynomial has whole differences, and sums of these are exact. Only the value itself
/// has to fit in a Word: what its differences lose beyond it, the sums lose again.
template <class Word>
class CubicSteps {
public:
    /// 2^halvings steps from 0 to `to`; `scale` is the number of fraction bits of the value, 3 * halvings or
    /// more.
    constexpr CubicSteps(int halvings, int scale, std::int32_t c1, std::int32_t c2, std::int32_t to)
        : value_{Word{1} << (scale - 1)}
    {
        const auto slope = 3 * static_cast<Word>(c1);
        const auto square = 3 * (static_cast<Word>(c2) - 2 * static_cast<Word>(c1));
        const auto cube = static_cast<Word>(to) - 3 * (static_cast<Word>(c2) - static_cast<Word>(c1));
        first_ = (slope << (scale - halvings)) + (square << (scale - 2 * halvings)) +
                 (cube << (scale - 3 * halvings));
        third_ = 6 * cube << (scale - 3 * halvings);
        second_ = (2 * square << (scale - 2 * halvings)) + third_;
    }

    /// The value after the next step, with the fraction.
    constexpr Word next()
    {
        value_ += first_;
        first_ += second_;
        second_ += third_;
        return value_;
    }

private:
    Word value_;
    Word first_;
    Word second_;
    Word third_;
};

/// All of a cubic but its end, in words that hold its points with a fraction of `scale` bits.
template <class Signed, class Word, class LineTo>
void flatten_in(const Segment& cubic, int halvings, int scale, LineTo& line_to)
{
    const Point c1 = cubic.c1 - cubic.from;
    const Point c2 = cubic.c2 - cubic.from;
    const Point to = cubic.to - cubic.from;
    CubicSteps<Word> x{halvings, scale, c1.x.raw(), c2.x.raw(), to.x.raw()};
    CubicSteps<Word> y{halvings, scale, c1.y.raw(), c2.y.raw(), to.y.raw()};
    const auto whole = [scale](Word value) {
        return Fixed::from_raw(static_cast<std::int32_t>(static_cast<Signed>(value) >> scale));
    };
    for (int steps = (1 << halvings) - 1; steps > 0; --steps)
        line_to(cubic.from + Point{whole(x.next()), whole(y.next())});
}

/// Whether all points of `cubic` lie so near to its beginning that they fit in 32 bits with 3 * halvings bits
/// of fraction.
inline bool is_small(const Segment& cubic, int halvings)
{
    const std::int32_t reach = (std::numeric_limits<std::int32_t>::max() >> 3 * halvings) - 1;
    const auto is_near = [&cubic, reach](Point point) {
        const Point away = point - cubic.from;
        return std::abs(away.x.raw()) <= reach && std::abs(away.y.raw()) <= reach;
    };
    return is_near(cubic.c1) && is_near(cubic.c2) && is_near(cubic.to);
}

/// Calls line_to(point) for the ends of the straight pieces that stand for `segment`: one for a line,
/// 2^halvings (0 … 8) of equal parameter length for a curve. The point it begins at is not among them, the
/// last one is exact, those between are rounded once: the pieces turn back in x or in y only where the curve
/// does.
template <class LineTo>
void flatten(const Segment& segment, int halvings, LineTo line_to)
{
    if (segment.kind == Segment::Kind::cubic && halvings != 0) {
        if (is_small(segment, halvings))
            flatten_in<std::int32_t, std::uint32_t>(segment, halvings, 3 * halvings, line_to);
        else
            flatten_in<std::int64_t, std::uint64_t>(segment, halvings, 32, line_to);
    }
    line_to(segment.to);
}

/// How often a segment has to be halved so that the pieces lie within `flatness` of it; no more than
/// most_halvings.
///
/// n pieces lie within 3 d / 4 n^2 of a curve, where d is the longer of |from - 2 c1 + c2| and
/// |c1 - 2 c2 + to|: a chord of a function f over 1/n is at most max |f''| / 8 n^2 off, and f'' is 6 times
/// what lies between those two.
int halvings_for(const Segment& segment);

}

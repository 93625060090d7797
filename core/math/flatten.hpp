#pragma once

#include "core/bytes/expects.hpp"
#include "core/bytes/op_counter.hpp"
#include "core/math/point.hpp"

#include <cstdint>

namespace kfast {

/// One piece of a stroke: a straight line, or a cubic Bezier curve with the control points c1 and c2.
///
/// The functions below require all points of a segment, and of both segments of a tween, to be less than
/// 32768 px apart in x and in y; nothing is checked. Drawings within ±16383 px always are, and drawings
/// within ±4095 px can also be tweened by progress beyond 0 … 1 and then be divided.
struct Segment {
    enum class Kind : std::uint8_t { line, cubic };

    Kind kind = Kind::line;
    Point from = {};
    Point c1 = {}; ///< only of cubics
    Point c2 = {};
    Point to = {};

    friend constexpr bool operator==(const Segment&, const Segment&) = default;
};

/// A segment that stays at one point.
constexpr Segment still_segment(Point at) { return {.from = at, .to = at}; }

/// The point that a segment leaves its beginning for: the first of its points that is elsewhere, or its end.
constexpr Point after_begin(const Segment& segment)
{
    if (segment.kind == Segment::Kind::line || (segment.c1 == segment.from && segment.c2 == segment.from))
        return segment.to;
    return segment.c1 == segment.from ? segment.c2 : segment.c1;
}

/// The point that a segment comes to its end from.
constexpr Point before_end(const Segment& segment)
{
    return after_begin({segment.kind, segment.to, segment.c2, segment.c1, segment.from});
}

/// A line as a curve, its control points at the thirds to 1/65536 of its length.
[[gnu::cold]] Segment as_cubic(const Segment& segment);

/// The segment with all points rounded to 1/64 px, halves up.
[[gnu::cold]] Segment rounded_to_grid(const Segment& segment);

/// The stretch of `whole` between two shares of its parameter; curves by de Casteljau's construction, each
/// point within 2/65536 px. Two stretches that share an end share its very bits.
[[gnu::cold]] Segment subsegment(const Segment& whole, Fraction begin, Fraction end);

/// The point on `segment` at a parameter, within 2/65536 px; on a line rounded once.
Point point_at(const Segment& segment, Fraction fraction);

/// Interpolates two segments of one kind, with separate progress for x and y, which may be beyond 0 … 1;
/// rounded once, exact at 0 and 1.
Segment tween(const Segment& a, const Segment& b, Progress x, Progress y);

/// How far the middles of chords may be from a curve. The corners of the pieces that replace it are beside
/// the curve, so that a piece takes away what it adds: no more than 2/3 of it outside, 1/3 inside.
inline constexpr Fixed flatness = Fixed::from_raw(Fixed::one / 16);

/// A curve is cut into any number of pieces up to max_steps, or into 64, 128 or 256.
inline constexpr int max_pieces = 256;
inline constexpr int max_steps = 32;

/// The points of a cubic at steps of equal parameter length by forward differences, in 32 bits without a
/// division. Each is moved away from the chord between its neighbours by 1/12 of its second difference: the
/// pieces between the points enclose the area that the curve does.
///
///     P(t) = from + C t + B t^2 + A t^3,  h = 1 / pieces
///     first  = C h + B h^2 + A h^3        from one point to the next
///     second = 2 B h^2 + 6 A h^3          from one first difference to the next
///     third  = 6 A h^3
///
/// Differences are kept in 1/65536 of a unit, which is 1/1024 px, or as much more as the cubic is larger than
/// 32 px. Points are off by 2.5 units at most where there are as many pieces as pieces_for() says.
class CubicSteps {
public:
    /// 2 … max_steps pieces.
    CubicSteps(const Segment& cubic, int pieces);

    /// The next point after the beginning and before the end.
    Point next() { return {x_.next(from_.x, shift_), y_.next(from_.y, shift_)}; }

private:
    static constexpr int result_bits = 4; ///< points come in 2^result_bits / 65536 px

    /// Along x or y.
    struct Axis {
        std::uint32_t value;
        std::uint32_t first;
        std::uint32_t second;
        std::uint32_t third;

        /// `from` is the beginning. Steps may be rounded up beyond the range of a difference; the sums cancel
        /// that.
        Fixed next(Fixed from, int shift)
        {
            value += first;
            first += second;
            second += third;
            const auto delta = static_cast<std::uint32_t>(static_cast<std::int32_t>(value) >> shift);
            return Fixed::from_raw(
                static_cast<std::int32_t>(static_cast<std::uint32_t>(from.raw()) + (delta << result_bits)));
        }
    };

    void set(Axis& axis, Fixed c1, Fixed c2, Fixed to, int pieces) const;

    Point from_;
    int shift_; ///< a unit is 2^(result_bits - shift) px
    Axis x_;
    Axis y_;
};

/// All of a cubic but its end, in 2 … max_steps pieces.
template <class LineTo>
void flatten_freely(const Segment& cubic, int pieces, LineTo& line_to)
{
    count_op(Op::piece, static_cast<std::uint32_t>(pieces));
    CubicSteps steps{cubic, pieces};
    for (int left = pieces - 1; left > 0; --left)
        line_to(steps.next());
}

/// Calls line_to(point) for the ends of the straight pieces that replace `segment`: one for a line,
/// `pieces` of equal parameter length for a curve. The point it begins at is not among them, the last one is
/// exact, those between are beside the curve (CubicSteps), except that of more than 32 every 32nd is on it.
template <class LineTo>
void flatten(const Segment& segment, int pieces, LineTo line_to)
{
    if (segment.kind == Segment::Kind::cubic && pieces > max_steps) {
        const Fraction part{Fraction::one / static_cast<std::uint32_t>(pieces / max_steps)};
        for (Fraction begin; begin.raw != Fraction::one; begin.raw += part.raw) {
            const Segment cubic = subsegment(segment, begin, {begin.raw + part.raw});
            if (begin.raw != 0)
                line_to(cubic.from);
            flatten_freely(cubic, max_steps, line_to);
        }
    } else if (segment.kind == Segment::Kind::cubic && pieces != 1) {
        flatten_freely(segment, pieces, line_to);
    }
    line_to(segment.to);
}

/// How many pieces a segment needs so that chords are within `flatness` of it.
///
/// n pieces are within 3 d / 4 n^2 of a curve, where d is the longer of |from - 2 c1 + c2| and
/// |c1 - 2 c2 + to|: a chord of a function f over 1/n is at most max |f''| / 8 n^2 off, and f'' is 6 times
/// a mean of those two.
int pieces_for(const Segment& segment);

/// The number of pieces that are about 2^coarseness times as long; at least 1, as `pieces` is.
constexpr int coarser(int pieces, int coarseness)
{
    expects(pieces >= 1 && coarseness >= 0);
    return ((pieces - 1) >> coarseness) + 1;
}

}

#pragma once

#include "core/segment.hpp"
#include "core/work.hpp"

#include <cstdint>
#include <type_traits>

namespace kfast {

/// How far the middles of chords may lie from a curve. The corners of the pieces that stand for it lie beside
/// the curve, so that a piece takes away what it adds: no more than 2/3 of it outside, 1/3 inside.
inline constexpr Fixed flatness = Fixed::from_raw(Fixed::one / 16);

/// A curve is cut into any number of pieces up to 32, or into 64, 128 or 256.
inline constexpr int most_pieces = 256;

/// One coordinate of a cubic at `pieces` steps of equal parameter length, each moved away from the chord
/// between its neighbours by 5/64 (1/16 and 1/64, each rounded down) of its second difference: the pieces
/// between the points enclose about what the curve does, where 1/12 would be exact.
///
/// n^3 times a polynomial has whole differences at n steps, and sums of these are exact. If n is a power of
/// two, 1/n^3 is a shift, and points are rounded to nearest, halves up. Otherwise the differences are rounded
/// when they are divided, and points are off by one at most. Only the value itself and its second difference
/// have to fit in a Word: what the others lose beyond it, the sums lose again.
template <class Word>
class CubicSteps {
public:
    /// From 0 to `to`; 2 … most_pieces pieces.
    CubicSteps(int pieces, Fixed c1, Fixed c2, Fixed to);

    /// The value after the next step.
    Fixed next()
    {
        value_ += first_;
        const std::int32_t bend = whole(second_);
        first_ += second_;
        second_ += third_;
        return Fixed::from_raw(whole(value_) - (bend >> 4) - (bend >> 6));
    }

private:
    /// In 64 bits as many as the most pieces need.
    using FractionBits = std::conditional_t<sizeof(Word) == 8, std::integral_constant<int, 24>, int>;

    std::int32_t whole(Word word) const
    {
        return static_cast<std::int32_t>(static_cast<std::make_signed_t<Word>>(word) >> fraction_bits_);
    }

    [[no_unique_address]] FractionBits fraction_bits_;
    Word value_;
    Word first_;
    Word second_;
    Word third_;
};

extern template class CubicSteps<std::uint32_t>;
extern template class CubicSteps<std::uint64_t>;

/// All of a cubic but its end.
template <class Word, class LineTo>
void flatten_in(const Segment& cubic, int pieces, LineTo& line_to)
{
    const Point c1 = cubic.c1 - cubic.from;
    const Point c2 = cubic.c2 - cubic.from;
    const Point to = cubic.to - cubic.from;
    did(sizeof(Word) == 8 ? Work::wide_piece : Work::piece, static_cast<std::uint32_t>(pieces));
    CubicSteps<Word> x{pieces, c1.x, c2.x, to.x};
    CubicSteps<Word> y{pieces, c1.y, c2.y, to.y};
    for (int steps = pieces - 1; steps > 0; --steps) {
        const Fixed right = x.next();
        line_to(cubic.from + Point{right, y.next()});
    }
}

/// Whether all points of `cubic` lie so near to its beginning that CubicSteps needs no more than 32 bits.
bool is_small(const Segment& cubic, int pieces);

/// Calls line_to(point) for the ends of the straight pieces that stand for `segment`: one for a line,
/// `pieces` of equal parameter length for a curve. The point it begins at is not among them, the last one is
/// exact, those between lie beside the curve (CubicSteps).
template <class LineTo>
void flatten(const Segment& segment, int pieces, LineTo line_to)
{
    if (segment.kind == Segment::Kind::cubic && pieces != 1) {
        if (is_small(segment, pieces))
            flatten_in<std::uint32_t>(segment, pieces, line_to);
        else
            flatten_in<std::uint64_t>(segment, pieces, line_to);
    }
    line_to(segment.to);
}

/// How many pieces a segment needs so that chords lie within `flatness` of it.
///
/// n pieces lie within 3 d / 4 n^2 of a curve, where d is the longer of |from - 2 c1 + c2| and
/// |c1 - 2 c2 + to|: a chord of a function f over 1/n is at most max |f''| / 8 n^2 off, and f'' is 6 times
/// what lies between those two.
int pieces_for(const Segment& segment);

/// A number of pieces, each about 2^coarseness times as long; 1 at least.
constexpr int coarser(int pieces, int coarseness) { return ((pieces - 1) >> coarseness) + 1; }

}

#pragma once

#include "core/segment.hpp"

namespace kfast {

/// Calls line_to(point) for the ends of the straight pieces that stand for `segment`: one for a line,
/// `curve_pieces` (1 … 65535) of equal parameter length for a curve. The point it begins at is not among
/// them, the last one is exact, those between within 2/65536 px of the curve.
///
/// n pieces lie within 3 d / 4 n^2 of the curve, where d is the longer of |from - 2 c1 + c2| and
/// |c1 - 2 c2 + to|: a chord of a function f over 1/n is at most max |f''| / 8 n^2 off, and f'' is 6 times
/// what lies between those two.
template <class LineTo>
void flatten(const Segment& segment, std::uint32_t curve_pieces, LineTo line_to)
{
    if (segment.kind == Segment::Kind::cubic)
        for (std::uint32_t piece = 1; piece < curve_pieces; ++piece)
            line_to(point_at(segment, Share::ratio(piece, curve_pieces)));
    line_to(segment.to);
}

}

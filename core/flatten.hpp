#pragma once

#include "core/segment.hpp"

namespace kfast {

/// Calls line_to(point) for the ends of the straight pieces that stand for `segment`: one for a line,
/// `curve_pieces` (1 … 65535) of equal parameter length for a curve. The last point is exact.
template <class LineTo>
void flatten(const Segment& segment, std::uint32_t curve_pieces, LineTo line_to)
{
    if (segment.kind == Segment::Kind::cubic)
        for (std::uint32_t piece = 1; piece < curve_pieces; ++piece)
            line_to(point_at(segment, Share::ratio(piece, curve_pieces)));
    line_to(segment.to);
}

}

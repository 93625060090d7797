#include "core/edge_budget.hpp"

#include "core/equalize.hpp"
#include "core/packed_drawing.hpp"

#include <algorithm>

namespace kfast {
namespace {

constexpr std::uint32_t inner_join_edges = 2;

}

/// This holds for any curve, so also where a velocity law takes the control points beyond those of both keys.
/// The curve turns no more than its control polygon, one whole turn: that is 2 arc pieces. Rounding adds to
/// that. A point is off by up to 1.5/65536 px (three nested roundings), so the heading of the shortest piece,
/// 1/256 px, by 3/256 rad, and a join by twice that, less than 0.0038 turns: that is e = 0.0076 arc pieces.
/// It counts only where a join has two pieces or more, and so at least 1 - e of its own: there are at most 2
/// arc / (1 - e) of these. No join has more than arc pieces, which is all that is left to say where e
/// nears 1.
///
/// In perspective it does not hold for any curve: what rounding adds is enlarged, and a curve may turn where
/// it comes nearer than is seen. There StrokeOutline keeps to it.
std::uint32_t arcs_within_curve(std::uint32_t arc, std::uint32_t joins)
{
    const std::uint32_t most = joins * (arc - 1);
    const std::uint32_t e = 76 * arc; // in 1/10000
    return e > 5000 ? most : std::min(most, 2 * arc + 2 * arc * e / (10000 - e) + 1);
}

EdgeBudget::EdgeBudget(const ObjectStyle& style, std::uint32_t curve_pieces)
    : is_filled_{style.is_filled}, is_stroked_{style.is_stroked},
      curve_pieces_{curve_pieces}, arc_{style.arc_pieces}, cap_{style.cap == Cap::round    ? arc_
                                                                : style.cap == Cap::square ? 3
                                                                                           : 1},
      bend_{style.join == Join::miter ? 2U : 1U}, corner_{style.join == Join::round ? arc_ : bend_},
      curve_arcs_{style.join == Join::round ? arcs_within_curve(arc_, curve_pieces - 1) : 0}
{
}

std::uint64_t EdgeBudget::between(PackedDrawing a, PackedDrawing b) const
{
    std::uint64_t edges = 0;
    EqualizedPair pair{a, b};
    while (const std::uint32_t segments = pair.next_stroke()) {
        edges += stroke_ends();
        for (std::uint32_t i = 0; i < segments; ++i)
            edges += segment_edges(pair.skip_segment());
    }
    return edges;
}

std::uint32_t EdgeBudget::segment_edges(bool curved) const
{
    const std::uint32_t pieces = curved ? curve_pieces_ : 1;
    std::uint32_t edges = is_filled_ ? pieces : 0;
    if (is_stroked_) {
        edges += 2 * pieces + (pieces - 1) * (inner_join_edges + bend_) + (curved ? curve_arcs_ : 0);
        edges += inner_join_edges + corner_;
    }
    return edges;
}

/// The fill is closed over its hub by two edges; a stroke has two caps, or one more segment that closes it.
std::uint32_t EdgeBudget::stroke_ends() const
{
    return (is_filled_ ? 2 : 0) + (is_stroked_ ? 2 * cap_ + 2 + inner_join_edges + corner_ : 0);
}

std::uint64_t object_edges(const ObjectView& object, std::span<const std::byte> drawings)
{
    KeyCursor keys = object.keys();
    Key from = keys.next();
    std::uint64_t most = 0;
    for (bool is_last = false; !is_last;) {
        is_last = keys.at_end();
        const Key next = is_last ? from : keys.next();
        const EdgeBudget budget{object.style, from.curve_pieces};
        const std::uint32_t to = object.has_arrivals ? from.arrival : next.drawing;
        most = std::max(most, budget.between(drawing_at(drawings, from.drawing), drawing_at(drawings, to)));
        from = next;
    }
    return most;
}

}

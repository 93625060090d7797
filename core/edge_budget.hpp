#pragma once

#include "core/item_view.hpp"
#include "core/packed_drawing.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// What the arcs at the `joins` within one flattened curve add to one piece for each, if half a turn has
/// `arc` pieces.
std::uint32_t arcs_within_curve(std::uint32_t arc, std::uint32_t joins);

/// Counts the edges that an object can need at most between two of its keys, for any time between them.
class EdgeBudget {
public:
    EdgeBudget(const ObjectStyle& style, std::uint32_t curve_pieces);

    /// For the way from drawing `a` to drawing `b`.
    std::uint64_t between(PackedDrawing a, PackedDrawing b) const;

private:
    std::uint32_t segment_edges(bool curved) const;
    std::uint32_t stroke_ends() const;

    bool is_filled_;
    bool is_stroked_;
    std::uint32_t curve_pieces_;
    std::uint32_t arc_;        ///< pieces of half a turn
    std::uint32_t cap_;        ///< edges of one cap
    std::uint32_t bend_;       ///< outer edges of a join within a curve, arcs apart
    std::uint32_t corner_;     ///< outer edges of a join between two segments
    std::uint32_t curve_arcs_; ///< edges that all the arcs within one curve add
};

/// The most edges that any moment of `object` needs: the largest figure of all its key intervals.
/// `drawings` is the scene's section of drawings.
std::uint64_t object_edges(const ObjectView& object, std::span<const std::byte> drawings);

}

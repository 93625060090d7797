#pragma once

#include <cstdint>

namespace kfast {

/// The operations that take time in the core, counted where they are done often. The fit report counts them
/// and knows the cost of each (host/fit/cost_table.hpp).
enum class Op : std::uint8_t {
    // From the time to outlines.
    picture,         ///< begun from scratch
    timeline,        ///< moved to a time
    key,             ///< whose value a track takes over
    item,            ///< looked at
    track,           ///< evaluated
    placement,       ///< made from the values of tracks
    law,             ///< applied
    bezier_law,      ///< applied, one that has to be solved
    bone,            ///< posed
    object,          ///< traced, once for its fill and once for its stroke
    stroke,          ///< of a drawing
    segment,         ///< of a drawing, read
    line,            ///< between two drawings
    curve,           ///< between two drawings
    split,           ///< of a segment, to have as many as its partner
    point,           ///< placed by a map that has to multiply
    wide_point,      ///< placed by such a map, in 64 bits
    projected_point, ///< in perspective
    carried_point,   ///< by a bone
    bent_point,      ///< by a backbone
    piece,           ///< of a curve
    pen_piece,       ///< a straight piece that a pen follows
    bend,            ///< between two of them
    slight_bend,     ///< between two of them, a corner on each side
    placed_corner,   ///< of a drawing that moves as a whole
    corner,          ///< of an outline
    chain,           ///< of an outline
    crossing,        ///< of a border between rows
    kept_chain,      ///< of a layer that stays as it is
    // From outlines to pixels.
    step,           ///< compared with the last picture
    passed_band,    ///< of rows that stay as they are
    passed_border,  ///< of the record, in one of these
    band,           ///< of rows
    band_chain,     ///< in a band
    straight_chain, ///< in a band, one that is straight
    border,         ///< of the record, read
    region,         ///< of a tile, painted
    edge_row,       ///< of a region with a single edge
    flat_pixel,     ///< crossed by an edge that is not steep
    chain_visit,    ///< to see whether a chain of a region belongs to a layer
    layer,          ///< laid on a region
    layer_row,      ///< of that
    layer_edge,     ///< through such a row
    bent_edge,      ///< one that bends
    sum_row,        ///< in which areas are summed up
    row_chain,      ///< a chain in it
    sum_part,       ///< of an edge in it
    sum_pixel,      ///< in it
    edge_group,     ///< of edges that overlap within a pixel
    line_crossing,  ///< of a line through it
    span,           ///< of even coverage
    fill,           ///< of a run of pixels
    filled_pixel,
    blended_pixel,
    faded_pixel, ///< of a group
};

inline constexpr std::uint8_t op_kinds = static_cast<std::uint8_t>(Op::faded_pixel) + 1;

#ifdef KFAST_COUNTS_WORK // only by the host side: on a device nothing is left of the counting

/// Where operations are counted, for each thread.
class OpCounter {
public:
    virtual ~OpCounter() = default;

    /// The counts of what is done for an item, by Op; valid until the next call.
    virtual std::uint32_t* counts_for(std::uint32_t path) = 0;

    std::uint32_t* counts = nullptr; ///< of the present item
};

inline constinit thread_local OpCounter* op_counter = nullptr; ///< the counter in use, if any

inline void count_op(Op op, std::uint32_t times = 1)
{
    if (op_counter != nullptr)
        op_counter->counts[static_cast<std::uint8_t>(op)] += times;
}

/// What follows is done for the item of this path (core/scene/item_view.hpp); 0: for none of them.
inline void count_ops_for(std::uint32_t path)
{
    if (op_counter != nullptr)
        op_counter->counts = op_counter->counts_for(path);
}

#else

constexpr void count_op(Op, std::uint32_t = 1) {}
constexpr void count_ops_for(std::uint32_t) {}

#endif

}

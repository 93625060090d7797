#pragma once

#include <cstdint>

namespace kfast {

/// What takes time in the core, where it is done often. The fit report counts it and knows what each of them
/// costs (host/fit/cost_table.hpp).
enum class Work : std::uint8_t {
    // From the time to outlines.
    picture,         ///< begun from scratch
    item,            ///< looked at
    track,           ///< evaluated
    key,             ///< read in search of a moment
    placement,       ///< made from the values of tracks
    law,             ///< applied
    bezier_law,      ///< likewise, one that has to be solved
    bone,            ///< posed
    object,          ///< traced, once for its fill and once for its stroke
    stroke,          ///< of a drawing
    line,            ///< segment between two drawings
    curve,           ///< likewise
    split,           ///< of a segment, to have as many as its partner
    point,           ///< placed by a map that has to multiply
    wide_point,      ///< likewise, in 64 bits
    projected_point, ///< in perspective
    carried_point,   ///< by a bone
    bent_point,      ///< by a backbone
    piece,           ///< of a curve
    wide_piece,      ///< likewise, in 64 bits
    pen_piece,       ///< a straight piece that a pen follows
    bend,            ///< between two of them
    slight_bend,     ///< likewise, a corner on each side
    corner,          ///< of an outline
    chain,           ///< of an outline
    copied_corner,   ///< of an outline that stands still
    copied_chain,    ///< likewise
    // From outlines to pixels.
    strip,         ///< of rows that are drawn together
    searched_row,  ///< for changes
    step_visit,    ///< of a row to a step of the picture
    swept_row,     ///< of a layer
    straight_part, ///< of a chain within a row that it runs through without a corner
    bent_part,     ///< likewise any other one
    edge,          ///< entered
    slab,          ///< between chains that disturb each other
    slab_edge,     ///< of a slab
    flat_edge,     ///< in more than one pixel of a row
    crossed_pixel, ///< by such an edge
    cell,          ///< of coverage, read
    span,          ///< of even coverage
    compared,      ///< stretch of two coverages
    marked,        ///< stretch between two borders
    inserted_run,  ///< into a list of runs, not behind the last one
    fill,          ///< of a stretch
    filled_pixel,
    blended_pixel,
    faded_pixel, ///< of a layer that is transparent as a whole
};

inline constexpr std::uint8_t work_kinds = static_cast<std::uint8_t>(Work::faded_pixel) + 1;

#ifdef KFAST_COUNTS_WORK // only by the host side: on a device nothing is left of the counting

/// Where it is counted, by the thread that counts.
class WorkTally {
public:
    virtual ~WorkTally() = default;

    /// The counts of what is done for an item, by Work; valid until the next call.
    virtual std::uint32_t* counts_for(std::uint32_t path) = 0;

    std::uint32_t* counts = nullptr; ///< of the present item
};

inline constinit thread_local WorkTally* work_tally = nullptr; ///< whoever counts

inline void did(Work work, std::uint32_t times = 1)
{
    if (work_tally != nullptr)
        work_tally->counts[static_cast<std::uint8_t>(work)] += times;
}

/// What follows is done for the item of this path (core/item_path.hpp); 0: for none of them.
inline void work_for(std::uint32_t path)
{
    if (work_tally != nullptr)
        work_tally->counts = work_tally->counts_for(path);
}

#else

constexpr void did(Work, std::uint32_t = 1) {}
constexpr void work_for(std::uint32_t) {}

#endif

}

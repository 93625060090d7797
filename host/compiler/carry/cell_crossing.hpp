#pragma once

#include "host/compiler/carry/backbone_cells.hpp"
#include "host/compiler/match/match_by_count.hpp"

#include <cstdint>

namespace kfast {

/// The cells that carry one side of a pair of strokes, and the backbone that carries most of it.
struct DeformingCells {
    const BackboneCells& cells;
    std::int32_t backbone;
};

/// Divides the segments of a stroke, both sides alike, so that they can follow the backbones: lines where
/// they pass from one segment of a backbone to another; curves that do so in the middle of the segments,
/// where their pieces meet smoothly whatever becomes of the nodes.
SegmentPairs divided_at_cells(const SegmentPairs& stroke, const DeformingCells& a, const DeformingCells& b);

}

#pragma once

#include "host/compiler/carry/backbone_cells.hpp"
#include "host/compiler/match/match_by_count.hpp"
#include "host/scene/model.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace kfast {

/// The cells that deform one side of a pair of strokes, and the backbone that deforms most of it.
struct DeformingCells {
    const BackboneCells& cells;
    std::int32_t backbone;
};

/// Divides the segments of a stroke, both sides alike, so that they can follow the backbones: lines where
/// they pass from one segment of a backbone to another; curves that do so in the middle of the segments,
/// where their pieces meet smoothly however the nodes move.
SegmentPairs divided_at_cells(const SegmentPairs& stroke, const DeformingCells& a, const DeformingCells& b);

/// As scene::Segment, before rounding.
struct RelativeSegment {
    bool cubic = false;
    RelativePoint c1;
    RelativePoint c2;
    RelativePoint to;
};

struct RelativeStroke {
    RelativePoint from;
    std::vector<RelativeSegment> segments;
};

using RelativeDrawing = std::vector<RelativeStroke>;

/// The drawing relative to the cells: the cells as given yield `drawing`. A point in cells of several
/// backbones goes with the one that has most of its stroke, a control point with the backbone of its vertex.
RelativeDrawing relative_drawing(const SegmentDrawing& drawing, const BackboneCells& cells);

/// The vertices of a stroke.
std::vector<Vec2> spots_of(const std::vector<Segment>& stroke);

/// The finest unit that all points of `drawings` can be stored in, as the format has it: 2^bits sixteenths
/// represent a segment.
std::uint32_t unit_bits_of(std::span<const RelativeDrawing> drawings);

/// Rounds every point once.
scene::Drawing rounded(const RelativeDrawing& drawing, std::uint32_t unit_bits);

}

#pragma once

#include "core/pose/equalize.hpp"
#include "host/scene/model.hpp"

#include <vector>

namespace kfast {

/// Segments that become each other, in 1/65536 px and both of the same kind.
using SegmentPairs = std::vector<Pair<Segment>>;

/// What corresponds in two drawings: for each stroke of the drawing that has fewer of them, the parts that it
/// breaks into, each paired with a stroke of the other. Where both have as many, a stroke has one part.
struct MatchedSegments {
    std::vector<std::vector<SegmentPairs>> strokes;
    bool breaks_b = false; ///< it is `b` that has fewer strokes
};

/// Drawings by their segments: each stroke has at least one, for a single point is a segment without extent.
using SegmentDrawing = std::vector<std::vector<Segment>>;

std::vector<Segment> side_of(const SegmentPairs& pairs, Segment Pair<Segment>::*side);

/// By the rules of core/pose/equalize.hpp; what is added there, also to an empty drawing, stands in the
/// result. A line that is paired with a curve is a curve. Two empty drawings have no strokes.
MatchedSegments match_by_count(const scene::Drawing& a, const scene::Drawing& b);

/// The two drawings, such that equalization pairs their segments in the same way without adding a point:
/// where a stroke breaks, all of its parts get as many segments as the largest.
Pair<SegmentDrawing> joined(const MatchedSegments& matched);

}

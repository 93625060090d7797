#pragma once

#include "core/pose/equalize.hpp"
#include "host/compiler/match/aligned_strokes.hpp"

#include <vector>

namespace kfast {

/// The places of two strokes that correspond: all their vertices and what the other side has in their stead.
/// Both sides have the same number, at most the sum of the segments.
using CorrespondingPlaces = Pair<std::vector<StrokePlace>>;

/// Vertices that go together are one place; between two such pairs the places are where the lengths from
/// there are in proportion. Both strokes have a segment.
CorrespondingPlaces corresponding_places(const AlignedStrokes& strokes);

}

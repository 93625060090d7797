#pragma once

#include "core/pose/equalize.hpp"
#include "host/compiler/match/aligned_strokes.hpp"
#include "host/compiler/match/measured_stroke.hpp"

#include <cstddef>
#include <vector>

/// Which vertices of two strokes become one point of the tween between them ("Points by length" in
/// host/compiler/README.md).
namespace kfast {

/// The directions in which a stroke reaches and leaves a vertex: of length 1, or 0 where it does not turn by
/// more than 30 degrees.
struct StrokeCorner {
    Vec2 in;
    Vec2 out;
};

/// The vertices of a stroke, in its direction.
struct StrokeVertices {
    std::vector<double> positions;     ///< fractions of the length, never falling
    std::vector<StrokeCorner> corners; ///< none at the ends of an open stroke
};

/// `stroke` has a segment.
StrokeVertices vertices_of(const MeasuredStroke& stroke);

/// How well vertex `i` of `a` and vertex `j` of `b` match that are `way` of the length apart: 0 (not at all)
/// … 2. Corners match over a longer distance the more similar their directions are.
double affinity(const StrokeVertices& a, std::size_t i, const StrokeVertices& b, std::size_t j, double way);

/// The pairs of vertices with the greatest sum of affinities such that both sides rise: first with first,
/// last with last, and between them those that match. Takes n log n for n vertices.
std::vector<Pair<std::size_t>> vertex_pairs(const StrokeVertices& a, const StrokeVertices& b);

/// The places of two strokes that correspond: all their vertices and what the other side has instead of them.
/// Both sides have the same number, at most the sum of the segments.
using CorrespondingPlaces = Pair<std::vector<StrokePlace>>;

/// Vertices that match are one place; between two such pairs the places are where the lengths from there are
/// in proportion. Both strokes have a segment.
CorrespondingPlaces corresponding_places(const AlignedStrokes& strokes);

}

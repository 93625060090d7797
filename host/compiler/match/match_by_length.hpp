#pragma once

#include "host/compiler/match/aligned_strokes.hpp"
#include "host/scene/model.hpp"

#include <optional>

namespace kfast {

/// Two drawings for one tween between keys: where it departs and where it arrives. Segments may have no
/// extent, which those of a scene do not.
struct MatchedDrawings {
    scene::Drawing from;
    scene::Drawing to;
};

/// Drawings that look like `a` and `b` to within 1/16 px and that equalization (core/pose/equalize.hpp) pairs
/// without adding points: they have the points that correspond by arc length, and closed strokes begin where
/// they fit each other best ("Points by length" in host/compiler/README.md). Single points and drawings whose
/// partner is empty stay as they are: equalization repeats them.
///
/// Strokes are turned round only where `reversal` allows it, and where both drawings have one alone: with
/// several the direction may distinguish a hole from what is around it.
///
/// None if either would have more than kfb::max_drawing_points.
std::optional<MatchedDrawings> match_by_length(const scene::Drawing& a, const scene::Drawing& b,
                                               Reversal reversal = Reversal::allowed);

}

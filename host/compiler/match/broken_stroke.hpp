#pragma once

#include "host/compiler/match/measured_stroke.hpp"

namespace kfast {

/// What a part of a broken stroke is to become.
struct PartTarget {
    double length = 0; ///< 0 for a single point
    Vec2 centre;       ///< of gravity
};

PartTarget target_of(const scene::Stroke& stroke);

/// Breaks a stroke that has a segment into one part for each target, with lengths in proportion to theirs but
/// none shorter than a sixteenth of an even division. Breaks move to a vertex nearby. A closed stroke begins
/// where the parts are then nearest to their targets, if those are at most 64.
std::vector<MeasuredStroke> broken(const MeasuredStroke& whole, const std::vector<PartTarget>& targets);

}

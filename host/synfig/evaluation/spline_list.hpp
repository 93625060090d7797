#pragma once

#include "host/synfig/evaluation/evaluator.hpp"

namespace kfast::synfig {

/// The points of a spline. A point that comes or goes slides out of, or into, the curve between its
/// neighbours.
List spline_list(Evaluator& evaluator, const ValueNode& node, double time);

/// A cubic between two points of a spline.
struct SplinePiece {
    Vec2 from;
    Vec2 leaving;
    Vec2 to;
    Vec2 arriving;

    SplinePiece(const SplinePoint& first, const SplinePoint& second)
        : from{first.vertex}, leaving{first.leaving()}, to{second.vertex}, arriving{second.arriving}
    {
    }
    Vec2 at(double share) const;
    Vec2 direction(double share) const;
    double length(double share = 1) const; ///< from its beginning
};

}

#pragma once

#include "host/synfig/evaluation/evaluator.hpp"

namespace kfast::synfig {

/// The points of a spline. A point that comes or goes slides out of, or into, the curve between its
/// neighbours.
List spline_list(Evaluator& evaluator, const ValueNode& node, double time);

/// A cubic between two points of a spline.
struct SplinePiece {
    Spot from;
    Spot leaving;
    Spot to;
    Spot arriving;

    SplinePiece(const SplinePoint& first, const SplinePoint& second)
        : from{first.vertex}, leaving{first.leaving()}, to{second.vertex}, arriving{second.arriving}
    {
    }
    Spot at(double share) const;
    Spot direction(double share) const;
    double length(double share = 1) const; ///< from its beginning
};

}

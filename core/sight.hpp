#pragma once

#include "core/flatten.hpp"
#include "core/projection.hpp"
#include "core/segment.hpp"

namespace kfast {

/// How the points of an object are seen: as they lie, or projected.
class Sight {
public:
    /// As they lie if `projection`, which must outlive it, is null. `coarseness` makes the pieces of curves
    /// that often twice as long as the precision asks for.
    Sight(const Projection* projection, int coarseness) : projection_{projection}, coarseness_{coarseness} {}

    Point operator()(Point at) const { return projection_ == nullptr ? at : (*projection_)(at); }
    /// Calls line_to(point) for the ends of the straight pieces that are seen in the place of `segment`. The
    /// pieces are projected: the projection of a curve is not the curve of the projected points.
    template <class LineTo>
    void flatten(const Segment& segment, LineTo line_to) const
    {
        kfast::flatten(segment, pieces_of(segment), [&](Point to) { line_to((*this)(to)); });
    }
    int coarseness() const { return coarseness_; }

private:
    int pieces_of(const Segment& segment) const;

    const Projection* projection_;
    int coarseness_;
};

}

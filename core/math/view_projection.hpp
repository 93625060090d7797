#pragma once

#include "core/math/flatten.hpp"
#include "core/math/projection.hpp"
#include "core/math/segment.hpp"

namespace kfast {

/// How the points of an object are seen: as they lie, or projected.
class ViewProjection {
public:
    /// As they lie if `projection`, which must outlive it, is null. `coarseness` makes the pieces of curves
    /// that often twice as long as the precision asks for.
    ViewProjection(const Projection* projection, int coarseness)
        : projection_{projection}, coarseness_{coarseness}
    {
    }

    bool is_flat() const { return projection_ == nullptr; }
    Point operator()(Point at) const { return projection_ == nullptr ? at : (*projection_)(at); }
    /// How many straight pieces are to be seen in the place of `segment`. The pieces are projected: the
    /// projection of a curve is not the curve of the projected points.
    int pieces_of(const Segment& segment) const;
    int coarseness() const { return coarseness_; }

private:
    const Projection* projection_;
    int coarseness_;
};

}

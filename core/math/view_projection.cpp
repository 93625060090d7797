#include "core/math/view_projection.hpp"

namespace kfast {

int ViewProjection::pieces_of(const Segment& segment) const
{
    if (segment.kind == Segment::Kind::line)
        return 1;
    const ViewProjection& seen = *this;
    const int needed = projection_ == nullptr
                           ? pieces_for(segment)
                           : pieces_for({segment.kind, seen(segment.from), seen(segment.c1), seen(segment.c2),
                                         seen(segment.to)});
    return coarser(needed, coarseness_);
}

}

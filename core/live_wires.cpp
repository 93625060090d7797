#include "core/live_wires.hpp"

#include "core/object_outline.hpp"

namespace kfast {

/// z goes by the law for x.
Point LiveWires::seen(Pair<Point> flat, Pair<Point> depths) const
{
    return see_(lerp(flat.a, flat.b, way_.x, way_.y), lerp(depths.a, depths.b, way_.x, way_.x).x);
}

template void LiveWires::trace(ObjectOutline& outline);

}

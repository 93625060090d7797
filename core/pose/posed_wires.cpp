#include "core/pose/posed_wires.hpp"

#include "core/raster/outline/object_outline.hpp"

namespace kfast {

/// z goes by the law for x.
Point PosedWires::seen(Pair<Point> flat, Pair<Point> depths) const
{
    const Fixed z = lerp(depths.a.x, depths.b.x, progress_.x);
    return see_.in_front(z)(lerp(flat.a, flat.b, progress_.x, progress_.y));
}

template void PosedWires::trace(ObjectOutline& outline);

}

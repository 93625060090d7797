#include "core/live_strokes.hpp"

#include "core/object_outline.hpp"
#include "core/work.hpp"

namespace kfast {

LiveStrokes::LiveStrokes(const CarriedDrawing& from, const CarriedDrawing& to, Progress way,
                         const LiveBackbones* backbones, const Affine& placement)
    : pair_(way.x == Way{} && way.y == Way{} ? EqualizedPair{from} : EqualizedPair{from, to}), way_{way},
      backbones_{backbones}, place_{placement}
{
}

/// `from` is where the segment before ended, the same bits. A line paired with a curve becomes a curve.
Segment LiveStrokes::live(const Pair<Segment>& both, Point from) const
{
    if (both.a.kind != both.b.kind)
        return live({as_cubic(both.a), as_cubic(both.b)}, from);
    did(both.a.kind == Segment::Kind::line ? Work::line : Work::curve);
    Segment segment{.kind = both.a.kind, .from = from, .to = live(both.a.to, both.b.to)};
    if (segment.kind == Segment::Kind::cubic) {
        segment.c1 = live(both.a.c1, both.b.c1);
        segment.c2 = live(both.a.c2, both.b.c2);
    }
    return segment;
}

Point LiveStrokes::live(Point a, Point b) const
{
    if (backbones_ != nullptr)
        return place_(backbones_->between(a, b, way_));
    return place_(a == b ? a : lerp(a, b, way_.x, way_.y));
}

template void LiveStrokes::trace(ObjectOutline& outline);

}

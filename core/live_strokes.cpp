#include "core/live_strokes.hpp"
#include "core/work.hpp"

namespace kfast {

LiveStrokes::LiveStrokes(const CarriedDrawing& from, const CarriedDrawing& to, Progress way,
                         const LiveBackbones* backbones, const Affine& placement)
    : pair_(way.x == Way{} && way.y == Way{} ? EqualizedPair{from} : EqualizedPair{from, to}), way_{way},
      backbones_{backbones}, place_{placement}
{
}

void LiveStrokes::trace(ObjectOutline& outline)
{
    while (const std::uint32_t segments = pair_.next_stroke())
        trace_stroke(segments, outline);
}

void LiveStrokes::trace_stroke(std::uint32_t segments, ObjectOutline& outline)
{
    did(Work::stroke);
    const Pair<Segment>& both = pair_.next_segment();
    const Pair<Point> first{both.a.from, both.b.from};
    Segment segment = live(both, live(first.a, first.b));
    outline.begin(segment.from);
    outline.add(segment);
    for (std::uint32_t i = 1; i < segments; ++i) {
        pair_.next_segment();
        segment = live(both, segment.to);
        outline.add(segment);
    }
    const bool ends_meet = first.a == both.a.to && first.b == both.b.to;
    const Pair<Point> hub = pair_.hub();
    outline.end(live(hub.a, hub.b), ends_meet && pair_.is_whole());
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

}

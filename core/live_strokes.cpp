#include "core/live_strokes.hpp"

namespace kfast {
namespace {

Segment placed(const Segment& segment, const Affine& placement)
{
    if (segment.kind == Segment::Kind::line)
        return {.kind = segment.kind, .from = placement(segment.from), .to = placement(segment.to)};
    return {segment.kind, placement(segment.from), placement(segment.c1), placement(segment.c2),
            placement(segment.to)};
}

}

void LiveStrokes::trace(ObjectOutline& outline)
{
    while (const std::uint32_t segments = pair_.next_stroke())
        trace_stroke(segments, outline);
}

void LiveStrokes::trace_stroke(std::uint32_t segments, ObjectOutline& outline)
{
    Pair<Segment> both = pair_.next_segment();
    const Pair<Point> first{both.a.from, both.b.from};
    const Segment begin = live(both);
    outline.begin(begin.from);
    outline.add(begin);
    for (std::uint32_t i = 1; i < segments; ++i) {
        both = pair_.next_segment();
        outline.add(live(both));
    }
    const bool ends_meet = first.a == both.a.to && first.b == both.b.to;
    const Pair<Point> hub = pair_.hub();
    outline.end(live({still_segment(hub.a), still_segment(hub.b)}).to, ends_meet && pair_.is_whole());
}

Segment LiveStrokes::live(const Pair<Segment>& both) const
{
    return placed(backbones_ == nullptr ? tween(both.a, both.b, way_.x, way_.y)
                                        : backbones_->between(both.a, both.b, way_),
                  placement_);
}

}

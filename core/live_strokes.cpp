#include "core/live_strokes.hpp"

namespace kfast {
namespace {

Segment mapped(const Segment& segment, const CanvasMap& map)
{
    if (segment.kind == Segment::Kind::line)
        return {.kind = segment.kind, .from = map(segment.from), .to = map(segment.to)};
    return {segment.kind, map(segment.from), map(segment.c1), map(segment.c2), map(segment.to)};
}

}

Progress progress_at(const KeyInterval& interval, Time time)
{
    if (time <= interval.from.time)
        return {};
    const auto passed = static_cast<std::uint32_t>((time - interval.from.time).ticks);
    const auto whole = static_cast<std::uint32_t>((interval.to.time - interval.from.time).ticks);
    if (passed >= whole)
        return {};
    const Share share = Share::ratio(passed, whole);
    return {progress(interval.from.law_x, share), progress(interval.from.law_y, share)};
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
    return mapped(tween(both.a, both.b, way_.x, way_.y), map_);
}

}

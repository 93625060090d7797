#include "core/carried_drawing.hpp"

#include "core/held_point.hpp"

namespace kfast {
namespace {

/// Rounded to 1/65536 px.
Point carried_by(std::span<const LiveBone> bones, Point point, const Binding& binding)
{
    std::int64_t x = 128;
    std::int64_t y = 128;
    binding.each([&](BoneShare share) {
        const Point part = bones[share.bone](point);
        x += std::int64_t{part.x.raw()} * share.weight;
        y += std::int64_t{part.y.raw()} * share.weight;
    });
    return held_point(x >> 8, y >> 8);
}

}

std::uint32_t CarriedDrawing::next_stroke()
{
    const std::uint32_t segments = drawing_.next_stroke();
    start_ = drawing_.start();
    if (!is_carried())
        return segments;
    at_rest_.next_stroke();
    binding_ = skin_.next();
    start_ = carried(start_, at_rest_.start(), binding_);
    at_ = start_;
    return segments;
}

Segment CarriedDrawing::next_segment()
{
    Segment segment = drawing_.next_segment();
    if (!is_carried())
        return segment;
    const Segment at_rest = at_rest_.next_segment();
    segment.from = at_;
    if (segment.kind == Segment::Kind::cubic)
        segment.c1 = carried(segment.c1, at_rest.c1, binding_);
    binding_ = skin_.next();
    if (segment.kind == Segment::Kind::cubic)
        segment.c2 = carried(segment.c2, at_rest.c2, binding_);
    segment.to = carried(segment.to, at_rest.to, binding_);
    at_ = segment.to;
    return segment;
}

Point CarriedDrawing::carried(Point point, Point at_rest, const Binding& binding) const
{
    const Point moved = carried_by(bones_, at_rest, binding);
    return held_point(std::int64_t{point.x.raw()} + moved.x.raw() - at_rest.x.raw(),
                      std::int64_t{point.y.raw()} + moved.y.raw() - at_rest.y.raw(), farthest_tweened);
}

}

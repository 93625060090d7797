#include "core/pose/posed_strokes.hpp"

#include "core/bytes/op_counter.hpp"
#include "core/raster/outline/object_outline.hpp"

namespace kfast {

/// z has the progress of x.
Point PosedWires::seen(Pair<Point> flat, Pair<Point> depths) const
{
    const Fixed z = lerp(depths.a.x, depths.b.x, progress_.x);
    return see_.in_front(z)(lerp(flat.a, flat.b, progress_.x, progress_.y));
}

template void PosedWires::trace(ObjectOutline& outline);

/// `from` is the end of the segment before, the same bits.
Segment PosedStrokes::live(const Pair<Segment>& both, Point from) const
{
    count_op(both.a.kind == Segment::Kind::line ? Op::line : Op::curve);
    Segment segment{.kind = both.a.kind, .from = from, .to = live(both.a.to, both.b.to)};
    if (segment.kind == Segment::Kind::cubic) {
        segment.c1 = live(both.a.c1, both.b.c1);
        segment.c2 = live(both.a.c2, both.b.c2);
    }
    return segment;
}

Point PosedStrokes::live(Point a, Point b) const
{
    if (backbones_ != nullptr)
        return place_(backbones_->between(a, b, progress_));
    return place_(a == b ? a : lerp(a, b, progress_.x, progress_.y));
}

template void trace_strokes(DeformedDrawing& drawing, const Affine& placement, ObjectOutline& outline);
template void PosedStrokes::trace(ObjectOutline& outline);

namespace {

/// The points of the tween between two drawings.
class KeptPoints {
public:
    KeptPoints(TweenReader& tween, ProgressXY progress, const PosedBackbones* backbones,
               const Affine& placement)
        : tween_{tween},
          progress_{progress},
          backbones_{backbones},
          place_{placement},
          is_simple_{backbones == nullptr && tween.is_short() && place_.is_shift()},
          shift_{place_.shift()}
    {
    }

    [[gnu::always_inline]] Point next()
    {
        return is_simple_ ? tween_.next_short_point(progress_) + shift_ : any();
    }

    Point hub() const
    {
        const Pair<Point> hub = tween_.hub();
        return backbones_ == nullptr ? place_(lerp(hub.a, hub.b, progress_.x, progress_.y)) : between(hub);
    }

private:
    [[gnu::noinline]] Point any()
    {
        return backbones_ == nullptr ? place_(tween_.next_point(progress_)) : between(tween_.next_points());
    }

    Point between(const Pair<Point>& both) const
    {
        return place_(backbones_->between(both.a, both.b, progress_));
    }

    TweenReader& tween_;
    ProgressXY progress_;
    const PosedBackbones* backbones_;
    PointMap place_;
    bool is_simple_; ///< most are: short points, only shifted
    Point shift_;
};

/// Replaces `segment` by the one that follows it.
void take_next(TweenReader& tween, KeptPoints& points, Segment& segment)
{
    segment.from = segment.to;
    segment.kind = Segment::Kind::line;
    if (tween.is_next_cubic()) {
        segment.kind = Segment::Kind::cubic;
        segment.c1 = points.next();
        segment.c2 = points.next();
    }
    count_op(segment.kind == Segment::Kind::cubic ? Op::curve : Op::line);
    segment.to = points.next();
}

}

void trace_kept(TweenReader tween, ProgressXY progress, const PosedBackbones* backbones,
                const Affine& placement, ObjectOutline& outline)
{
    KeptPoints points{tween, progress, backbones, placement};
    Segment segment;
    for (std::uint32_t stroke = 0; stroke < tween.strokes(); ++stroke) {
        count_op(Op::stroke);
        const std::uint32_t segments = tween.next_stroke();
        const Point first = points.next();
        outline.begin(first);
        segment.to = first;
        for (std::uint32_t i = 0; i < segments; ++i) {
            take_next(tween, points, segment);
            outline.add(segment);
        }
        outline.end(tween.is_whole() ? first : points.hub(), tween.is_closed());
    }
}

}

#pragma once

#include "core/bytes/op_counter.hpp"
#include "core/math/point_map.hpp"
#include "core/pose/deformed_drawing.hpp"
#include "core/pose/equalize.hpp"
#include "core/pose/posed_backbones.hpp"
#include "core/pose/tween_cache.hpp"
#include "core/time/key_interval.hpp"

#include <cstdint>

namespace kfast {

/// Tells `outline` the strokes of one drawing, placed: begin(point), add(segment) for all segments of a
/// stroke, and end(hub, is_closed). A single point counts as one segment. `drawing` has not been read, and is
/// read to its end.
template <class Outline>
void trace_strokes(DeformedDrawing& drawing, const Affine& placement, Outline& outline)
{
    const PointMap place{placement};
    for (std::uint32_t left = drawing.strokes(); left > 0; --left) {
        count_op(Op::stroke);
        const std::uint32_t segments = drawing.next_stroke();
        const Point start = drawing.start();
        const Point first = place(start);
        outline.begin(first);
        Segment read = still_segment(start);
        Segment placed = still_segment(first);
        if (segments == 0)
            outline.add(placed);
        for (std::uint32_t i = 0; i < segments; ++i) {
            read = drawing.next_segment();
            count_op(read.kind == Segment::Kind::line ? Op::line : Op::curve);
            placed = {.kind = read.kind, .from = placed.to, .to = place(read.to)};
            if (read.kind == Segment::Kind::cubic) {
                placed.c1 = place(read.c1);
                placed.c2 = place(read.c2);
            }
            outline.add(placed);
        }
        outline.end(first, read.to == start);
    }
}

/// The strokes between two drawings at one moment of their way, placed.
class PosedStrokes {
public:
    /// `make(is_second)` returns either drawing, unread, of so many strokes (EqualizedPair); at the very
    /// beginning of the way it is asked for the first alone. `backbones`, which may be null, carry the
    /// drawings; they and `placement` must outlive the strokes.
    PosedStrokes(Pair<std::uint32_t> strokes, FunctionRef<DeformedDrawing(bool)> make, ProgressXY progress,
                 const PosedBackbones* backbones, const Affine& placement)
        : pair_{strokes.a, progress.is_at_beginning() ? strokes.a : strokes.b, progress.is_at_beginning(),
                make},
          progress_{progress}, backbones_{backbones}, place_{placement}
    {
    }

    /// Tells `outline` each stroke, as trace_strokes() does. Of an outline that has end_part(), this ends the
    /// parts of a broken stroke instead.
    template <class Outline>
    void trace(Outline& outline)
    {
        while (const std::uint32_t segments = pair_.next_stroke())
            trace_stroke(segments, outline);
    }

private:
    template <class Outline>
    void trace_stroke(std::uint32_t segments, Outline& outline)
    {
        count_op(Op::stroke);
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
        if constexpr (requires { outline.end_part(); })
            if (!pair_.is_whole())
                return outline.end_part();
        const bool ends_meet = first.a == both.a.to && first.b == both.b.to;
        const Pair<Point> hub = pair_.hub();
        outline.end(live(hub.a, hub.b), ends_meet && pair_.is_whole());
    }

    Segment live(const Pair<Segment>& both, Point from) const;
    Point live(Point a, Point b) const;

    EqualizedPair<DeformedDrawing> pair_;
    ProgressXY progress_;
    const PosedBackbones* backbones_;
    PointMap place_;
};

// For pictures, compiled where live() can be laid into it.
class ObjectOutline;
extern template void trace_strokes(DeformedDrawing& drawing, const Affine& placement, ObjectOutline& outline);
extern template void PosedStrokes::trace(ObjectOutline& outline);

/// As PosedStrokes, of two drawings without bones that are kept: the same strokes, sooner.
void trace_kept(TweenReader tween, ProgressXY progress, const PosedBackbones* backbones,
                const Affine& placement, ObjectOutline& outline);

}

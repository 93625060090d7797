#pragma once

#include "core/carried_drawing.hpp"
#include "core/equalize.hpp"
#include "core/key_interval.hpp"
#include "core/live_backbones.hpp"
#include "core/point_map.hpp"
#include "core/tween_cache.hpp"
#include "core/work.hpp"

#include <cstdint>

namespace kfast {

/// The strokes between two drawings at one moment of their way, placed.
class LiveStrokes {
public:
    /// At the very beginning of the way, `from` alone. `backbones`, which may be null, carry the drawings;
    /// they and `placement` must outlive the strokes.
    LiveStrokes(const CarriedDrawing& from, const CarriedDrawing& to, Progress way,
                const LiveBackbones* backbones, const Affine& placement);

    /// Tells `outline` each stroke: begin(point), add(segment) for all of its segments, and end(hub,
    /// is_closed). Of an outline that has end_part(), this ends the parts of a broken stroke instead.
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
        if constexpr (requires { outline.end_part(); })
            if (!pair_.is_whole())
                return outline.end_part();
        const bool ends_meet = first.a == both.a.to && first.b == both.b.to;
        const Pair<Point> hub = pair_.hub();
        outline.end(live(hub.a, hub.b), ends_meet && pair_.is_whole());
    }

    Segment live(const Pair<Segment>& both, Point from) const;
    Point live(Point a, Point b) const;

    EqualizedPair<CarriedDrawing> pair_;
    Progress way_;
    const LiveBackbones* backbones_;
    PointMap place_;
};

// For pictures, compiled where live() can be laid into it.
class ObjectOutline;
extern template void LiveStrokes::trace(ObjectOutline& outline);

/// As LiveStrokes, of two drawings without bones that are kept: the same strokes, sooner.
void trace_kept(TweenReader tween, Progress way, const LiveBackbones* backbones, const Affine& placement,
                ObjectOutline& outline);

}

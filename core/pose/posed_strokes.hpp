#pragma once

#include "core/bytes/op_counter.hpp"
#include "core/math/affine.hpp"
#include "core/math/flatten.hpp"
#include "core/math/point.hpp"
#include "core/math/projection.hpp"
#include "core/pose/equalize.hpp"
#include "core/pose/posed_backbones.hpp"
#include "core/pose/posed_bones.hpp"
#include "core/pose/tween_cache.hpp"
#include "core/scene/packed_drawing.hpp"
#include "core/time/track.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// A key drawing of a wire frame: x and y of its points, and a drawing of the same form whose x is their z.
/// All segments are lines. Both are offsets in a scene's section of drawings.
struct WireDrawing {
    std::uint32_t flat = 0;
    std::uint32_t depths = 0;
};

/// The strokes of a wire frame between two drawings at one progress, as they are seen. Both pairs are
/// equalized in step, because only the numbers of strokes and segments matter. Few scenes have wires: their
/// code is cold, so that a board can leave it in flash.
class PosedWires {
public:
    /// At progress 0, `from` alone. `drawings` and `projection` must outlive the wires.
    PosedWires(std::span<const std::byte> drawings, const WireDrawing& from, const WireDrawing& to,
               ProgressXY progress, const Projection& projection)
        : flat_{pair_of(drawings, from.flat, to.flat, progress)},
          depths_{pair_of(drawings, from.depths, to.depths, progress)},
          progress_{progress},
          see_{projection}
    {
    }

    /// Passes each stroke to `outline`, which is a stroke's, as PosedStrokes::trace() does; but points are as
    /// they are seen, and hubs have no meaning.
    template <class Outline>
    [[gnu::cold]] void trace(Outline& outline)
    {
        while (const std::uint32_t segments = flat_.next_stroke()) {
            depths_.next_stroke();
            trace_stroke(segments, outline);
        }
    }

private:
    static EqualizedPair<PackedDrawing> pair_of(std::span<const std::byte> drawings, std::uint32_t from,
                                                std::uint32_t to, ProgressXY progress)
    {
        const bool is_single = progress.is_at_beginning();
        return {drawing_at(drawings, from).strokes(), drawing_at(drawings, is_single ? from : to).strokes(),
                is_single, [&](bool is_second) { return drawing_at(drawings, is_second ? to : from); }};
    }

    template <class Outline>
    void trace_stroke(std::uint32_t segments, Outline& outline)
    {
        count_op(Op::stroke);
        const Pair<Segment>& flat = flat_.next_segment();
        const Pair<Segment>& depths = depths_.next_segment();
        const Pair<Point> first{flat.a.from, flat.b.from};
        const Pair<Point> first_depths{depths.a.from, depths.b.from};
        Segment segment{.to = seen(first, first_depths)};
        outline.begin(segment.to);
        for (std::uint32_t i = 0; i < segments; ++i) {
            if (i != 0) {
                flat_.next_segment();
                depths_.next_segment();
            }
            count_op(Op::line, 2); // flat, and in depth
            segment.from = segment.to;
            segment.to = seen({flat.a.to, flat.b.to}, {depths.a.to, depths.b.to});
            outline.add(segment);
        }
        const bool ends_meet = end_where_began(first, flat) && end_where_began(first_depths, depths);
        outline.end(segment.to, ends_meet && flat_.is_whole());
    }

    static bool end_where_began(const Pair<Point>& first, const Pair<Segment>& last)
    {
        return first.a == last.a.to && first.b == last.b.to;
    }

    [[gnu::cold]] Point seen(Pair<Point> flat, Pair<Point> depths) const;

    EqualizedPair<PackedDrawing> flat_;
    EqualizedPair<PackedDrawing> depths_;
    ProgressXY progress_;
    const Projection& see_;
};

// For pictures, compiled where seen() can be inlined.
class ObjectOutline;
extern template void PosedWires::trace(ObjectOutline& outline);

/// Passes the strokes of one drawing, placed, to `outline`: begin(point), add(segment) for all segments of a
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

/// The strokes between two drawings at one progress, placed.
class PosedStrokes {
public:
    /// `make(is_second)` returns either drawing, unread, with that many strokes (EqualizedPair); at
    /// progress 0 it is asked only for the first. `backbones`, which may be null, deform the drawings;
    /// they and `placement` must outlive the strokes.
    PosedStrokes(Pair<std::uint32_t> strokes, FunctionRef<DeformedDrawing(bool)> make, ProgressXY progress,
                 const PosedBackbones* backbones, const Affine& placement)
        : pair_{strokes.a, progress.is_at_beginning() ? strokes.a : strokes.b, progress.is_at_beginning(),
                make},
          progress_{progress},
          backbones_{backbones},
          place_{placement}
    {
    }

    /// Passes each stroke to `outline`, as trace_strokes() does. If an outline has end_part(), this ends the
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

// For pictures, compiled where live() can be inlined.
class ObjectOutline;
extern template void trace_strokes(DeformedDrawing& drawing, const Affine& placement, ObjectOutline& outline);
extern template void PosedStrokes::trace(ObjectOutline& outline);

/// Like PosedStrokes, for two drawings without bones that are kept: the same strokes, faster.
void trace_kept(TweenReader tween, ProgressXY progress, const PosedBackbones* backbones,
                const Affine& placement, ObjectOutline& outline);

}

#pragma once

#include "core/bytes/op_counter.hpp"
#include "core/math/point.hpp"
#include "core/math/projection.hpp"
#include "core/math/segment.hpp"
#include "core/pose/equalize.hpp"
#include "core/scene/packed_drawing.hpp"
#include "core/time/key_interval.hpp"

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

/// The strokes of a wire frame between two drawings at one moment of their way, as they are seen. Both pairs
/// are equalized in step, for only the numbers of strokes and segments decide. Few scenes have wires: their
/// code is cold, so that a board can leave it in flash.
class PosedWires {
public:
    /// At the very beginning of the way, `from` alone. `drawings` and `projection` must outlive the wires.
    PosedWires(std::span<const std::byte> drawings, const WireDrawing& from, const WireDrawing& to,
               ProgressXY progress, const Projection& projection)
        : flat_{pair_of(drawings, from.flat, to.flat, progress)},
          depths_{pair_of(drawings, from.depths, to.depths, progress)}, progress_{progress}, see_{projection}
    {
    }

    /// Tells `outline`, which is a stroke's, each stroke, as PosedStrokes::trace() does; but points are as
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

// For pictures, compiled where seen() can be laid into it.
class ObjectOutline;
extern template void PosedWires::trace(ObjectOutline& outline);

}

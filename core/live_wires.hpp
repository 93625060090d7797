#pragma once

#include "core/equalize.hpp"
#include "core/key_interval.hpp"
#include "core/packed_drawing.hpp"
#include "core/point.hpp"
#include "core/projection.hpp"
#include "core/segment.hpp"
#include "core/work.hpp"

#include <cstdint>

namespace kfast {

/// A key drawing of a wire frame: x and y of its points, and a drawing of the same form whose x is their z.
/// All segments are lines.
struct WireDrawing {
    PackedDrawing flat;
    PackedDrawing depths;
};

/// The strokes of a wire frame between two drawings at one moment of their way, as they are seen. Both pairs
/// are equalized in step, for only the numbers of strokes and segments decide. Few scenes have wires: their
/// code is cold, so that a board can leave it in flash.
class LiveWires {
public:
    /// At the very beginning of the way, `from` alone. `projection` must outlive the wires.
    LiveWires(const WireDrawing& from, const WireDrawing& to, Progress way, const Projection& projection)
        : LiveWires{from, to, way, projection, way.is_at_beginning()}
    {
    }

    /// Tells `outline`, which is a stroke's, each stroke, as LiveStrokes::trace() does; but points are as
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
    LiveWires(const WireDrawing& from, const WireDrawing& to, Progress way, const Projection& projection,
              bool is_on_key)
        : flat_{is_on_key ? EqualizedPair{from.flat} : EqualizedPair{from.flat, to.flat}},
          depths_{is_on_key ? EqualizedPair{from.depths} : EqualizedPair{from.depths, to.depths}}, way_{way},
          see_{projection}
    {
    }

    template <class Outline>
    void trace_stroke(std::uint32_t segments, Outline& outline)
    {
        did(Work::stroke);
        const Pair<Segment>& flat = flat_.next_segment();
        const Pair<Segment>& depths = depths_.next_segment();
        const Pair<Segment> first = flat;
        const Pair<Segment> first_depths = depths;
        Segment segment{.to = seen({flat.a.from, flat.b.from}, {depths.a.from, depths.b.from})};
        outline.begin(segment.to);
        for (std::uint32_t i = 0; i < segments; ++i) {
            if (i != 0) {
                flat_.next_segment();
                depths_.next_segment();
            }
            did(Work::line, 2); // flat, and in depth
            segment.from = segment.to;
            segment.to = seen({flat.a.to, flat.b.to}, {depths.a.to, depths.b.to});
            outline.add(segment);
        }
        const bool ends_meet = end_where_began(first, flat) && end_where_began(first_depths, depths);
        outline.end(segment.to, ends_meet && flat_.is_whole());
    }

    static bool end_where_began(const Pair<Segment>& first, const Pair<Segment>& last)
    {
        return first.a.from == last.a.to && first.b.from == last.b.to;
    }

    [[gnu::cold]] Point seen(Pair<Point> flat, Pair<Point> depths) const;

    EqualizedPair<PackedDrawing> flat_;
    EqualizedPair<PackedDrawing> depths_;
    Progress way_;
    const Projection& see_;
};

// For pictures, compiled where seen() can be laid into it.
class ObjectOutline;
extern template void LiveWires::trace(ObjectOutline& outline);

}

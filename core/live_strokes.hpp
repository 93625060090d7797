#pragma once

#include "core/canvas_map.hpp"
#include "core/equalize.hpp"
#include "core/object_outline.hpp"
#include "core/object_view.hpp"

#include <cstdint>

namespace kfast {

/// The share of the way between two keys, apart for x and y.
struct Progress {
    Share x;
    Share y;
};

/// How far the way of `interval` has come at `time`; nothing of it on and before its first key.
Progress progress_at(const KeyInterval& interval, Time time);

/// The strokes between two drawings at one moment of their way, on the panel.
class LiveStrokes {
public:
    /// `map` must outlive the strokes.
    LiveStrokes(const PackedDrawing& from, const PackedDrawing& to, Progress way, const CanvasMap& map)
        : pair_{from, to}, way_{way}, map_{map}
    {
    }

    void trace(ObjectOutline& outline);

private:
    void trace_stroke(std::uint32_t segments, ObjectOutline& outline);
    Segment live(const Pair<Segment>& both) const;

    EqualizedPair<PackedDrawing> pair_;
    Progress way_;
    const CanvasMap& map_;
};

}

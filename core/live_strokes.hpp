#pragma once

#include "core/carried_drawing.hpp"
#include "core/equalize.hpp"
#include "core/key_interval.hpp"
#include "core/live_backbones.hpp"
#include "core/object_outline.hpp"
#include "core/point_map.hpp"

#include <cstdint>

namespace kfast {

/// The strokes between two drawings at one moment of their way, placed.
class LiveStrokes {
public:
    /// At the very beginning of the way, `from` alone. `backbones`, which may be null, carry the drawings;
    /// they and `placement` must outlive the strokes.
    LiveStrokes(const CarriedDrawing& from, const CarriedDrawing& to, Progress way,
                const LiveBackbones* backbones, const Affine& placement);

    void trace(ObjectOutline& outline);

private:
    void trace_stroke(std::uint32_t segments, ObjectOutline& outline);
    Segment live(const Pair<Segment>& both, Point from) const;
    Point live(Point a, Point b) const;

    EqualizedPair<CarriedDrawing> pair_;
    Progress way_;
    const LiveBackbones* backbones_;
    PointMap place_;
};

}

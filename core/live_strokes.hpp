#pragma once

#include "core/affine.hpp"
#include "core/equalize.hpp"
#include "core/key_interval.hpp"
#include "core/object_outline.hpp"
#include "core/packed_drawing.hpp"

#include <cstdint>

namespace kfast {

/// The strokes between two drawings at one moment of their way, on the panel.
class LiveStrokes {
public:
    /// `placement` must outlive the strokes.
    LiveStrokes(const PackedDrawing& from, const PackedDrawing& to, Progress way, const Affine& placement)
        : pair_{from, to}, way_{way}, placement_{placement}
    {
    }

    void trace(ObjectOutline& outline);

private:
    void trace_stroke(std::uint32_t segments, ObjectOutline& outline);
    Segment live(const Pair<Segment>& both) const;

    EqualizedPair<PackedDrawing> pair_;
    Progress way_;
    const Affine& placement_;
};

}

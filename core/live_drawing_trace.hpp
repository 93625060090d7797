#pragma once

#include "core/affine.hpp"
#include "core/live_drawing.hpp"
#include "core/object_outline.hpp"
#include "core/point.hpp"

namespace kfast {

/// Where the drawing that is shown begins; the origin if it is empty.
Point start_of(const LiveDrawing& drawing);

/// Adds the strokes that are shown, placed.
void trace_live_strokes(const LiveDrawing& drawing, const Affine& placement, ObjectOutline& outline);

}

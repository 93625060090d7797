#pragma once

#include "core/bytes/function_ref.hpp"
#include "core/math/stroke_trimmer.hpp"
#include "core/raster/outline/object_outline.hpp"

namespace kfast {

/// Adds to `outline` what a trim leaves of the strokes that trace(Affine{}, outline) adds to it, placed: it
/// is called several times, and adds the same ones each time.
[[gnu::cold]] void trace_trimmed(const Trim& trim, const Affine& placement, ObjectOutline& outline,
                                 FunctionRef<void(const Affine&, ObjectOutline&)> trace);

}

#pragma once

#include "core/packed_drawing.hpp"

namespace kfast {

/// Of two drawings that have been checked: as many strokes, with the same segments of the same kinds.
bool is_built_alike(PackedDrawing a, PackedDrawing b);

/// Of a drawing that has been checked: three strokes of lines for each backbone, with as many points, at
/// least two.
bool are_backbones(PackedDrawing drawing);

}

#pragma once

#include "core/packed_drawing.hpp"

/// Of drawings that have been checked.
namespace kfast {

/// As many strokes, with the same segments of the same kinds.
bool is_built_alike(PackedDrawing a, PackedDrawing b);

bool has_only_lines(PackedDrawing drawing);

}

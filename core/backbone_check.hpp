#pragma once

#include "core/packed_drawing.hpp"

namespace kfast {

/// Of a drawing that has been checked: three strokes of lines for each backbone, with as many points, at
/// least two.
bool are_backbones(PackedDrawing drawing);

}

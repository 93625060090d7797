#pragma once

#include "host/art/document/document.hpp"
#include "host/lottie/drawings/moving_drawing.hpp"

#include <vector>

namespace kfast::lottie {

/// Replaces each of the drawings by what is left of it. Where the end of an open path is passed, there are
/// two pieces; a closed one is one, through its beginning.
void trim(const art::Trim& trim, const std::vector<MovingDrawing*>& drawings);

/// Corners without tangents become arcs of that radius, each at most as far as the middle of its sides. The
/// ends of open outlines stay.
MovingDrawing with_rounded_corners(MovingDrawing drawing, const art::Channel& radius);

}

#pragma once

#include "host/lottie/drawings/moving_drawing.hpp"

namespace kfast::lottie {

/// Corners without tangents become arcs of that radius, each at most as far as the middle of its sides. The
/// ends of open outlines stay.
MovingDrawing with_rounded_corners(MovingDrawing drawing, const art::Channel& radius);

}

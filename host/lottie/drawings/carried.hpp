#pragma once

#include "host/art/document/document.hpp"
#include "host/lottie/drawings/moving_drawing.hpp"

namespace kfast::lottie {

/// Whether it never changes, except in depth.
bool is_still(const art::Transform& transform);

/// The moments of all that moves its plane.
Moments moments_of(const art::Transform& transform);

/// The drawing in the coordinates outside of the transform.
MovingDrawing carried(MovingDrawing drawing, const art::Transform& transform);

/// The drawing while it is shown; at other times, it is empty.
MovingDrawing while_shown(MovingDrawing drawing, const std::vector<art::Span>& shown);

}

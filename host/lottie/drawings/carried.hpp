#pragma once

#include "host/art/document/document.hpp"
#include "host/lottie/drawings/moving_drawing.hpp"

namespace kfast::lottie {

/// Whether it is the same all along, but for its depth.
bool is_still(const art::Transform& transform);

/// Of all that moves its plane.
Moments moments_of(const art::Transform& transform);

/// The drawing as it is seen outside of the transform.
MovingDrawing carried(MovingDrawing drawing, const art::Transform& transform);

/// The drawing while it is shown; at other times, it is empty.
MovingDrawing while_shown(MovingDrawing drawing, const std::vector<art::Span>& shown);

}

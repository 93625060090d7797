#pragma once

#include "host/art/document/document.hpp"
#include "host/lottie/drawings/moving_drawing.hpp"
#include "host/lottie/layers/composition.hpp"

#include <vector>

namespace kfast::lottie {

/// What something is seen through: the inside of a drawing, in the coordinates of what lies behind it.
struct Window {
    MovingDrawing drawing;
    FillRule rule = FillRule::nonzero;
    bool is_convex = false; ///< at all times one convex polygon, and no other shape
};

Window window_of(const art::Animated<art::Drawing>& drawing);

/// Leaves of nodes what is seen through the window, as far as they are in it, out of it, or fills that can be
/// cut: any by a convex window, convex polygons by any window. False if something beyond it stays.
bool cut_to(const Window& window, std::vector<art::Node>& nodes, const art::Span& seen, art::Budget& budget);

}

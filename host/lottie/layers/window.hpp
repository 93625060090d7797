#pragma once

#include "host/art/document/document.hpp"
#include "host/lottie/drawings/moving_drawing.hpp"
#include "host/lottie/layers/composition.hpp"

#include <vector>

namespace kfast::lottie {

/// A clip: the inside of a drawing, in the coordinates of what is clipped.
struct Window {
    MovingDrawing drawing;
    FillRule rule = FillRule::nonzero;
    bool is_convex = false; ///< at all times one convex polygon, and no other shape
};

Window window_of(const art::Animated<art::Drawing>& drawing);

/// Keeps of nodes what is visible through the window, as far as they are inside, outside, or fills that can
/// be cut: any by a convex window, convex polygons by any window. False if something beyond it stays.
bool cut_to(const Window& window, std::vector<art::Node>& nodes, const art::Span& seen, art::Budget& budget);

}

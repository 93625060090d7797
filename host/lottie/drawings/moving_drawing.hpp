#pragma once

#include "host/art/budget.hpp"
#include "host/art/geometry/drawing.hpp"
#include "host/lottie/drawings/moments.hpp"

#include <functional>
#include <vector>

namespace kfast::lottie {

/// A drawing as a function of time, exact at every moment; what it is made of can be put together without
/// a loss, and keys are found once, at the end.
struct MovingDrawing {
    std::function<art::Drawing(double)> at;
    Moments moments;           ///< between them it changes smoothly; none: it never changes
    bool changes_form = false; ///< the numbers of its outlines and curves may change at any time
    double cost = 1;           ///< of asking for it once, in points that are computed
};

MovingDrawing moving(art::Animated<art::Drawing> drawing);

/// The outlines of all, in their order. At least one.
MovingDrawing together(std::vector<MovingDrawing> drawings);

/// How far baked keys may be from what they stand for, in pixels.
inline constexpr double baked_tolerance = 1.0 / 32;

/// Where the ways between the moments are those of one ease, they keep it; elsewhere there are as many keys
/// as baked_tolerance needs. Where the form changes, the drawing jumps from one form to the other.
art::Animated<art::Drawing> keys_of(const MovingDrawing& drawing, art::Budget& budget);

}

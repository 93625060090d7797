#pragma once

#include "host/compiler/extent.hpp"
#include "host/scene/model.hpp"

namespace kfast {

/// Where things may be in space: bounds for every moment.
struct Depth {
    double nearest = 0;     ///< how far in front of the canvas they come at most, in pixels
    bool is_turned = false; ///< they may turn about x or y, or what they lie in
};

/// Of what lies in `item`; `outside` is that of what the item lies in.
///
/// What turns about x or y comes nearer by as much as it lies away from its pivot, times the sine of the
/// angle.
Depth depth_inside(const Depth& outside, const scene::Item& item, const Extents& extents);

/// By what perspective enlarges lengths at most, wherever they lie on the canvas.
double perspective_bound(const Depth& depth, const scene::Scene& scene);

}

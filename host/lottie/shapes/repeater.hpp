#pragma once

#include "host/lottie/shapes/shapes.hpp"

namespace kfast::lottie {

/// The copies of a repeater ("rp") in place of the items before it: groups that paint the same, the topmost
/// first.
std::vector<ShapeItem> repeated(const std::vector<ShapeItem>& items, const Json& repeater,
                                const Reading& reading);

}

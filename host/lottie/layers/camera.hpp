#pragma once

#include "host/lottie/layers/animation.hpp"

#include <optional>

namespace kfast::lottie {

/// The distance of the viewer, in pixels, by the camera of the file if there is one: it has to look straight
/// at the middle of the canvas and stay there. Of others there is a loss, and their distance alone.
std::optional<double> read_camera(Animation& animation);

}

#pragma once

#include "host/lottie/layers/composition.hpp"
#include "host/lottie/shapes/shapes.hpp"

namespace kfast::lottie {

/// Reports what a layer has that no scene has: expressions, effects, styles, blend modes, and unknown
/// members. Once for each layer, wherever it is used.
void report_unread(const Json& layer, Animation& animation, const Reading& reading);

/// Reports expressions within a layer, or its transform alone.
void report_expressions(const Json& part, const std::string& path, Animation& animation,
                        const Reading& reading);

}

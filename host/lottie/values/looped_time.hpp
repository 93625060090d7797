#pragma once

#include "core/time/time.hpp"
#include "host/art/document/document.hpp"
#include "host/lottie/shapes/shapes.hpp"
#include "host/lottie/values/json.hpp"

#include <optional>

namespace kfast::lottie {

/// A remapping of time that goes evenly from one frame of the composition to another one, again and again.
struct LoopedTime {
    double from = 0;   ///< of the scene: when the first pass begins that may be seen
    double period = 1; ///< how long a pass takes
    double begin = 0;  ///< of the composition: where it begins
    double end = 0;    ///< where it ends, or turns back
    Loop loop = Loop::repeat;
};

/// That of a layer which is seen for more than one pass; nothing if it has another, or none.
std::optional<LoopedTime> looped_time(const Json& layer, const Reading& reading, const art::Span& seen,
                                      double frame_rate);

}

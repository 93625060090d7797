#pragma once

#include "host/art/document/document.hpp"
#include "host/lottie/values/channel.hpp"
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

/// That of a layer which is seen for more than one pass; nothing if it has another, or none. `outer` is the
/// time around the layer.
std::optional<LoopedTime> looped_time(const Json& layer, const LayerTime& outer, const art::Span& seen,
                                      double frame_rate, art::Budget& budget);

}

#pragma once

#include "host/lottie/layers/layer.hpp"
#include "host/lottie/values/looped_time.hpp"

#include <optional>

namespace kfast::lottie {

/// The use of a symbol that shows what the composition of a layer does, whose `layers` these are. The symbol
/// is read with `reading`, which does not change symbols that are there, when it is first used. Nothing if no
/// symbol shows the same.
std::optional<art::Use> use_looped(const Layer& layer, const Json& layers, const LoopedTime& time,
                                   const Reading& reading, Animation& animation);
std::optional<art::Use> use_evenly(const Layer& layer, const Json& layers, const LayerTime& time,
                                   const Reading& reading, Animation& animation);

}

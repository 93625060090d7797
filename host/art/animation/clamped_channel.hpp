#pragma once

#include "host/art/animation/animated.hpp"

namespace kfast::art {

/// The channel as it is where its values are held between `low` and `high` at each time, rather than at its
/// keys: there are keys where it goes beyond one of them and comes back. An ease that swings beyond both of
/// its values, which are within, is kept as it is.
Channel clamped(const Channel& channel, double low, double high);

}

#pragma once

#include "host/lottie/layers/layer.hpp"

namespace kfast::lottie {

/// What the composition behind a layer draws, with the layer's start, stretch and time remapping. Throws
/// WrongMember when there is none, or it uses itself.
std::vector<art::Node> read_precomposition(const Layer& layer, Animation& animation);

}

#pragma once

#include "host/lottie/layers/layer.hpp"

namespace kfast::lottie {

/// Applies the masks of a layer to what it draws: those that show or hide all of it, and those that cut a
/// solid to their own shape. Others are reported.
void apply_masks(std::vector<art::Node>& nodes, const Layer& layer);

}

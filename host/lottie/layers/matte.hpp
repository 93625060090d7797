#pragma once

#include "host/lottie/layers/layer.hpp"

namespace kfast::lottie {

/// The layer whose picture another one is matted by.
struct MatteSource {
    const Layer& layer;
    std::vector<art::Node> nodes; ///< what it draws, in its own coordinates
    art::Span shown;
};

/// Applies a matte ("tt") to what a layer draws, if it shows or hides all of it. Others are reported.
void apply_matte(std::vector<art::Node>& nodes, const Layer& layer, MatteSource source);

/// That it is not applied.
void report_matte(const Layer& layer);

}

#pragma once

#include "host/lottie/layers/animation.hpp"
#include "host/lottie/shapes/shapes.hpp"

namespace kfast::lottie {

/// Layers that see each other: the file's, or those of a precomposition.
struct Composition {
    const Json& layers; ///< the uppermost first
    const Around* around = nullptr;
    /// When it is seen, in the frames that Reading::time leads to.
    art::Span seen = {};
};

/// What they draw, the lowest first.
std::vector<art::Node> read_composition(const Composition& composition, Animation& animation,
                                        const Reading& reading);

}

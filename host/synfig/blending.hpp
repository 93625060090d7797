#pragma once

#include "host/synfig/layer.hpp"

namespace kfast::synfig {

/// What becomes of a layer because of its blend method.
enum class Blending {
    normal,
    behind, ///< painted below all that lies below it
    left_out,
};

/// Adds a loss where that is not what the layer asks for. What covers all of the canvas is left out rather
/// than painted over the rest.
Blending blending_of(const Layer& layer, bool covers_all);

}

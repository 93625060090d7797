#pragma once

#include "host/synfig/reading/layer.hpp"

#include <vector>

namespace kfast::synfig {

/// Applies a skeleton deformation to all that is below it. If its bones keep their lengths, it becomes a
/// skeleton that deforms the shapes; otherwise their drawings follow it point by point.
std::vector<art::Node> deformed(const Layer& layer, std::vector<art::Node> nodes);

}

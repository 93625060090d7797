#pragma once

#include "host/synfig/reading/layer.hpp"

#include <vector>

namespace kfast::synfig {

/// What a skeleton deformation makes of all that lies below it. Where its bones keep their lengths, it
/// becomes a skeleton that carries the shapes; otherwise their drawings follow it point by point.
std::vector<art::Node> deformed(const Layer& layer, std::vector<art::Node> nodes);

}

#pragma once

#include "host/synfig/reading/layer.hpp"

#include <vector>

namespace kfast::synfig {

/// Takes the movements of groups and shapes into the drawings of the shapes, so that all of them stand
/// where the nodes stand. Names, opacities and when nodes are seen stay.
void flatten(std::vector<art::Node>& nodes, const Layer& layer);

}

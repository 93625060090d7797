#pragma once

#include "host/scene/model.hpp"

#include <vector>

namespace kfast {

/// By what the tracks of an item enlarge lengths in it at most, in any direction and at any moment.
double scale_bound(const std::vector<scene::Track>& tracks);

/// By what each symbol is enlarged at most, over all of its uses and all that they lie in; 0 if it is not
/// used.
std::vector<double> symbol_scale_bounds(const scene::Scene& scene);

}

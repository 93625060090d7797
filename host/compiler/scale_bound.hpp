#pragma once

#include "host/scene/model.hpp"

#include <vector>

namespace kfast {

/// By what the scales of an item enlarge lengths in it at most, in any direction and at any moment.
double scale_bound(const std::vector<scene::Track>& tracks);

}

#pragma once

#include "host/scene/model.hpp"

#include <string>
#include <vector>

namespace kfast {

/// The names of all items in the order in which a .kfb stores them, as every_item() reads them; of a use
/// without a name that of its symbol.
std::vector<std::string> item_names(const scene::Scene& scene);

}

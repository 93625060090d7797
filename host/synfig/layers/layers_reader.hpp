#pragma once

#include "host/synfig/reading/layer.hpp"

#include <pugixml.hpp>
#include <vector>

namespace kfast::synfig {

/// What the layers of a canvas draw, the lowest first.
std::vector<art::Node> read_layers(pugi::xml_node canvas, Reading& reading, const Scope& scope);

}

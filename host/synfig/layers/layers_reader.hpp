#pragma once

#include "host/synfig/reading/layer.hpp"

#include <optional>
#include <pugixml.hpp>
#include <vector>

namespace kfast::synfig {

/// What the layers of a canvas draw, the lowest first.
std::vector<art::Node> read_layers(pugi::xml_node canvas, Reading& reading, const Scope& scope);

/// What outlines draw: a line if they have one width, and otherwise the shape that they cover. Nothing for
/// layers of other types.
std::optional<art::Node> read_line_layer(const Layer& layer);

}

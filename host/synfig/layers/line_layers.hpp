#pragma once

#include "host/synfig/reading/layer.hpp"

#include <optional>

namespace kfast::synfig {

/// What outlines draw: a line of one width where theirs is one, and otherwise the shape that they cover.
/// Nothing for layers of other types.
std::optional<art::Node> read_line_layer(const Layer& layer);

}

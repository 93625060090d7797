#pragma once

#include "host/scene/model.hpp"
#include "host/text/diagnostic.hpp"

namespace kfast {

/// Warns of arcs and pies that become longer, shorter or turn from key to key by so much that they leave
/// their circle in between, by three quarters of a pixel or more: points go straight. Each object has one
/// warning at most, for where it leaves furthest.
void warn_of_drifting_arcs(const scene::Scene& scene, Diagnostics& diagnostics);

}

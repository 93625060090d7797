#pragma once

#include "host/scene/model.hpp"
#include "host/text/diagnostic.hpp"

namespace kfast {

/// Warns of arcs and pies whose angles change from key to key by so much that they leave their circle in
/// between, by three quarters of a canvas pixel or more: points move straight. Up to 16 times between two
/// keys are sampled. Each object has at most one warning, for the time at which it is farthest away; those
/// that bones or backbones deform have none.
void warn_of_drifting_arcs(const scene::Scene& scene, Diagnostics& diagnostics);

}

#pragma once

#include "host/scene/model.hpp"
#include "host/text/diagnostic.hpp"

namespace kfast {

/// Warns of arcs and pies whose angles change from key to key by so much that they leave their circle in
/// between, by three quarters of a pixel of the canvas or more: points go straight. Up to 16 moments between
/// two keys are looked at. Each object has one warning at most, for the moment at which it is furthest away;
/// those that bones or backbones bend have none.
void warn_of_drifting_arcs(const scene::Scene& scene, Diagnostics& diagnostics);

}

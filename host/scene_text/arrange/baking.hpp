#pragma once

#include "host/art/document/document.hpp"
#include "host/art/losses.hpp"
#include "host/scene_text/arrange/arrange.hpp"

#include <vector>

namespace kfast::scene_text {

struct Arranging;

/// Bakes what the node and all nodes inside of it do into their drawings, as keys: their transforms do
/// nothing after that. Rotations in space, and shapes that bones deform, cannot be baked and are losses.
void bake(art::Node& node, const Arranging& arranging);

/// Items have no skew: a constant skew becomes a rotation, a scale and another rotation, and a skew that
/// changes over time is baked.
void straighten(std::vector<art::Node>& nodes, const Arranging& arranging);

}

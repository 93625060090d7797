#pragma once

#include "host/art/document/document.hpp"
#include "host/art/losses.hpp"
#include "host/scene_text/arrange/arrange.hpp"

#include <vector>

namespace kfast::scene_text {

struct Arranging;

/// Puts what the node and all nodes inside of it do into their drawings, as keys: their transforms do
/// nothing after that. Turns in space, and shapes that bones carry, cannot be put there and are losses.
void bake(art::Node& node, const Arranging& arranging);

/// Items do not lean: what leans all the time alike becomes a turn, a growth and another turn, and what
/// leans more or less over time is baked.
void straighten(std::vector<art::Node>& nodes, const Arranging& arranging);

}

#pragma once

#include "host/art/document/document.hpp"
#include "host/art/losses.hpp"

namespace kfast::scene_text {

struct Arranging;

/// Puts what the node and all nodes inside of it do into their drawings, as keys: their transforms do
/// nothing after that. Turns in space, and shapes that bones carry, cannot be put there and are losses.
void bake(art::Node& node, const Arranging& arranging);

}

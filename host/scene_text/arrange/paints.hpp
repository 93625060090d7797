#pragma once

#include "host/art/document/document.hpp"

#include <cstdint>
#include <vector>

namespace kfast::scene_text {

/// Makes fills and lines such as objects have: opacities that change become those of nodes, and what one
/// object cannot say of a fill and a line becomes two. The scene is `length` ticks long.
void part_paints(std::vector<art::Node>& nodes, std::int32_t length);

}

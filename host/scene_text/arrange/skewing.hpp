#pragma once

#include "host/art/document/document.hpp"
#include "host/scene_text/arrange/arrange.hpp"

#include <vector>

namespace kfast::scene_text {

/// Items do not lean: what leans all the time alike becomes a turn, a growth and another turn, and what
/// leans more or less over time is baked.
void straighten(std::vector<art::Node>& nodes, const Arranging& arranging);

}

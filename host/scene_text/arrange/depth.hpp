#pragma once

#include "host/art/document/document.hpp"
#include "host/scene_text/arrange/arrange.hpp"

#include <vector>

namespace kfast::scene_text {

/// Lets groups lie no deeper in each other than scenes hold: those beyond are dissolved, and what they do is
/// baked.
void limit_depth(std::vector<art::Node>& nodes, const Arranging& arranging);

}

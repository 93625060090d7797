#pragma once

#include "host/art/document/document.hpp"

#include <vector>

namespace kfast::scene_text {

/// Puts transforms that stand still into what they act on, wherever that looks the same: into points, widths
/// and places, or into transforms below. Groups that then do nothing vanish unless they have a name and more
/// than one node; a group with one node becomes that node if one item can do what both do.
void fold(std::vector<art::Node>& nodes);

}

#pragma once

#include "host/kdl/document.hpp"

#include <vector>

namespace kfast::scene_text {

/// Makes symbols of drawings that stand in several keys of objects, unless they are short, and lets the keys
/// use them. Returns the symbols.
std::vector<kdl::Node> share_drawings(std::vector<kdl::Node>& items);

}

#pragma once

#include "host/art/document/document.hpp"
#include "host/kdl/document.hpp"
#include "host/scene_text/values/writing.hpp"

#include <vector>

namespace kfast::scene_text {

/// Objects, groups and uses, in their order.
std::vector<kdl::Node> item_nodes(const std::vector<art::Node>& nodes, Writing& writing);

}

#pragma once

#include "host/art/document/document.hpp"
#include "host/kdl/document.hpp"
#include "host/scene_text/values/writing.hpp"

namespace kfast::scene_text {

/// The node `object` of a node that is a shape.
kdl::Node object_node(const art::Node& node, Writing& writing);

}

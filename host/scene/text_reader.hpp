#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/node_words.hpp"
#include "host/scene/outline.hpp"
#include "host/scene/reading.hpp"

#include <cstddef>
#include <vector>

namespace kfast::scene {

/// As read_shape(), for the node text, whose form has been checked but for its words.
std::vector<Outline> read_text_shape(const kdl::Node& node, std::size_t points_left, Reading& reading);

NodeWords text_words();

}

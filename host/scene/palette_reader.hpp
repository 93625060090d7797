#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/node_words.hpp"
#include "host/scene/reading.hpp"

namespace kfast::scene {

/// Declares the names inside the node in `reading.palette`.
void read_palette(const kdl::Node& node, Reading& reading);

std::vector<NodeWords> palette_words();

}

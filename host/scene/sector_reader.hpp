#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/node_words.hpp"
#include "host/scene/outline.hpp"
#include "host/scene/reading.hpp"

#include <cstddef>
#include <vector>

namespace kfast::scene {

/// As read_shape(), for the nodes arc and pie, whose form has been checked.
std::vector<Outline> read_arc(const kdl::Node& node, std::size_t points_left, Reading& reading);
std::vector<Outline> read_pie(const kdl::Node& node, std::size_t points_left, Reading& reading);

/// Of arcs of circles, and of ellipses.
std::vector<std::vector<PropertyWords>> arc_words();
std::vector<PropertyWords> pie_words();

}

#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/node_words.hpp"
#include "host/scene/outline.hpp"
#include "host/scene/reading.hpp"

#include <cstddef>
#include <vector>

namespace kfast::scene {

/// As read_shape(), for the nodes star and regular, whose form has been checked.
std::vector<Outline> read_star(const kdl::Node& node, std::size_t points_left, Reading& reading);
std::vector<Outline> read_regular(const kdl::Node& node, std::size_t points_left, Reading& reading);

std::vector<PropertyWords> star_words();
std::vector<PropertyWords> regular_words();

}

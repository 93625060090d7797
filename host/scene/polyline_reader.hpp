#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/node_words.hpp"
#include "host/scene/outline.hpp"
#include "host/scene/reading.hpp"

#include <cstddef>
#include <vector>

namespace kfast::scene {

/// As read_shape(), for the nodes polygon, line and curve, whose form has been checked.
std::vector<Outline> read_polygon(const kdl::Node& node, std::size_t points_left, Reading& reading);
std::vector<Outline> read_line(const kdl::Node& node, std::size_t points_left, Reading& reading);
std::vector<Outline> read_curve(const kdl::Node& node, std::size_t points_left, Reading& reading);

std::vector<PropertyWords> curve_words();

}

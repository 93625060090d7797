#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/model.hpp"
#include "host/scene/node_words.hpp"
#include "host/scene/reading.hpp"

namespace kfast::scene {

/// What `node`, an input, says of a drawing; what is wrong is reported.
DrawingInput read_drawing_input(const kdl::Node& node, Reading& reading);

std::vector<PropertyWords> drawing_input_words();

}

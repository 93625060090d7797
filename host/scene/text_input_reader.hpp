#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/model.hpp"
#include "host/scene/node_words.hpp"
#include "host/scene/reading.hpp"

namespace kfast::scene {

/// What an input node of kind=text says. What is wrong is reported, and then one that takes a place.
TextInput read_text_input(const kdl::Node& node, Reading& reading);

std::vector<PropertyWords> text_input_words();

}

#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/model.hpp"
#include "host/schema/node_form.hpp"

namespace kfast::scene {

/// What an input node of kind=text says. What is wrong is reported, and then one that takes a place.
TextInput read_text_input(const kdl::Node& node, SceneContext& context);

std::vector<PropertySchema> text_input_words();

}

#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/model.hpp"
#include "host/schema/node_form.hpp"

namespace kfast::scene {

/// What `node`, an input, says of a drawing; what is wrong is reported.
DrawingInput read_drawing_input(const kdl::Node& node, SceneContext& context);

std::vector<PropertySchema> drawing_input_words();

}

#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/schema/node_schema.hpp"

#include <string_view>

namespace kfast::scene {

inline constexpr std::string_view input_name = "input";

/// Adds what `node` says to the inputs; what is wrong is reported.
void add_input(const kdl::Node& node, SceneContext& context);

/// After everything that may go by them.
void warn_of_unused_inputs(SceneContext& context);

/// Of numbers, texts and drawings.
std::vector<NodeSchema> input_words();

}

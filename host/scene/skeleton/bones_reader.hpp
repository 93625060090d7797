#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/schema/node_form.hpp"

#include <string_view>

namespace kfast::scene {

inline constexpr std::string_view bones_name = "bones";

/// Adds the skeleton that `node` describes to those of `context`; reports what is wrong.
void add_skeleton(const kdl::Node& node, SceneContext& context);

/// Called after all objects have been read.
void warn_of_unused_skeletons(SceneContext& context);

NodeSchema bones_schema();

}

#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/schema/node_form.hpp"

#include <string_view>
#include <vector>

namespace kfast::scene {

inline constexpr std::string_view let_name = "let";

/// Defines the variables of all nodes `let`, in their order, and lets what follows use them; what is wrong is
/// reported.
void read_variables(const std::vector<const kdl::Node*>& nodes, SceneContext& context);

/// Called after everything that may use them.
void warn_of_unused_variables(SceneContext& context);

NodeSchema let_schema();

}

#pragma once

#include "core/scene/input_view.hpp"
#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"

#include <cstddef>
#include <optional>

namespace kfast::scene {

/// The index of the input that `name` names, which is of this type and in use then. Reports it if there is
/// none.
std::optional<std::size_t> use_input(const kdl::Value& name, InputType type, SceneContext& context);

/// The same for one that a label shows, a number or a text.
std::optional<std::size_t> use_label_input(const kdl::Value& name, SceneContext& context);

}

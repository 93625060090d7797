#pragma once

#include "host/geometry/outline.hpp"
#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"

#include <optional>
#include <vector>

/// Places on the canvas. Each function reports what is wrong and then returns nothing.
namespace kfast::scene {

/// All values of `node`, by twos; there must be at least one.
std::optional<std::vector<Vec2>> read_spots(const kdl::Node& node, SceneContext& context);

/// The two values of `node`.
std::optional<Vec2> read_spot(const kdl::Node& node, SceneContext& context);

/// A text with two numbers, as in at="20,200".
std::optional<Vec2> read_spot(const kdl::Value& value, SceneContext& context);

}

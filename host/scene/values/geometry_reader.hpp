#pragma once

#include "host/geometry/outline.hpp"
#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/model.hpp"

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

/// Points on the canvas. Each function reports what is wrong and then returns nothing.
namespace kfast::scene {

/// All values of `node`, by twos; there must be at least one.
std::optional<std::vector<Vec2>> read_spots(const kdl::Node& node, SceneContext& context);

/// The two values of `node`.
std::optional<Vec2> read_spot(const kdl::Node& node, SceneContext& context);

/// A text with two numbers, as in at="20,200".
std::optional<Vec2> read_spot(const kdl::Value& value, SceneContext& context);

/// The strokes of the data of an SVG path, in_range(). Nothing when it is wrong, which is reported.
std::optional<std::vector<Outline>> read_path_data(const kdl::Value& value, std::size_t points_left,
                                                   SceneContext& context);

/// Like read_shape(), for the node path, whose form has been checked.
std::vector<Outline> read_path(const kdl::Node& node, std::size_t points_left, SceneContext& context);

/// A path that something follows, one stroke with an extent; else it is reported and nothing is returned.
/// `what` follows it, "an item".
std::optional<Outline> read_followed_path(const kdl::Value& data, std::string_view what,
                                          SceneContext& context);

/// What the item of `track along "DATA"` follows. Nothing when it is no single stroke with an extent, which
/// is reported.
std::optional<Path> read_along_path(const kdl::Value& data, SceneContext& context);

}

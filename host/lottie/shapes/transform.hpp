#pragma once

#include "host/lottie/shapes/shapes.hpp"

namespace kfast::lottie {

/// "ks" of a layer, with its rotations in space ("ddd") and its direction along the path ("ao").
art::Transform read_layer_transform(const Json& layer, const Reading& reading);

/// Sets the position of a transform from "p" of `owner`. Along a path where it has tangents, and where
/// `turns` asks for the direction.
void read_position(art::Transform& transform, const Json& owner, const Reading& reading, bool turns);

/// The value of a channel that always has the same one.
std::optional<double> steady_value(const art::Channel& channel);

/// Whether it never leaves its plane.
bool is_flat(const art::Transform& transform);

/// Whether it is skewed, and its form changes: a scene can only have it in the points of what is drawn.
bool changes_while_skewed(const art::Transform& transform);

/// Lottie scales before it skews, a transform does the opposite: converts the one into the other where the
/// scales differ.
void skew_before_scaling(art::Transform& transform);

}

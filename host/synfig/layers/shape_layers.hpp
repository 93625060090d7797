#pragma once

#include "host/synfig/reading/layer.hpp"

#include <optional>
#include <vector>

namespace kfast::synfig {

/// What is drawn by layers that fill a shape: regions, circles, rectangles, polygons, stars and checker
/// boards. Nothing for layers of other types.
std::optional<art::Node> read_shape_layer(const Layer& layer);

/// The outline along the points of a spline, in the units of the file.
scene::Outline outline_along(const List& points, Vec2 origin);

/// Colour, opacity and fill rule from the parameters that all shapes have.
art::Fill fill_of(const Layer& layer);
/// A node with the name, and the opacity of the parameter "amount".
art::Node node_of(const Layer& layer);
/// Whether the parameter "origin" changes, so that a shape is drawn about (0, 0) and moved: both axes have
/// keys of their own then.
bool moves_as_a_whole(const Layer& layer);
void move_by_origin(art::Node& node, const Layer& layer);

}

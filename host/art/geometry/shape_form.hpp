#pragma once

#include "host/geometry/outline.hpp"

#include <variant>
#include <vector>

namespace kfast::art {

/// The shapes of the scene language that an importer may write; each has the numbers of its node.
struct CircleForm {
    scene::Vec2 centre;
    double radius = 0;
};
struct EllipseForm {
    scene::Vec2 centre;
    double radius_x = 0;
    double radius_y = 0;
};
struct RectForm {
    scene::Vec2 upper_left;
    double width = 0;
    double height = 0;
    double corner = 0;
};
struct PolygonForm {
    std::vector<scene::Vec2> spots; ///< at least three
};
struct LineForm {
    std::vector<scene::Vec2> spots; ///< at least two
};
struct PathForm {};

using ShapeForm = std::variant<PathForm, CircleForm, EllipseForm, RectForm, PolygonForm, LineForm>;

/// The shape that the scene's compiler turns into exactly the same stroke, point by point, after its rounding
/// to 1/16 px. Its numbers have the fewest decimals, up to five, for which that holds; corners of polygons
/// and lines are multiples of 1/16 px. Outlines that nothing else draws, and those that are not in_range(),
/// are paths.
ShapeForm shape_form(const scene::Outline& outline);

}

#pragma once

#include "host/art/geometry/drawing.hpp"
#include "host/kdl/document.hpp"
#include "host/scene_text/values/writing.hpp"

#include <span>
#include <vector>

namespace kfast::scene_text {

/// The shapes that draw each of the drawings of an object, whose points are rounded as they are stored:
/// circles, rectangles and so on where possible, an outline being of one kind in all drawings, and else
/// paths. `empty` for an empty drawing.
std::vector<std::vector<kdl::Node>> shapes_of(std::span<const art::Drawing* const> drawings);

/// Makes symbols of drawings that are in several keys of objects, of `symbols` as well, unless they are
/// short, and lets the keys use them. Returns those that it makes; `names` are those of all symbols.
std::vector<kdl::Node> share_drawings(std::vector<kdl::Node>& symbols, std::vector<kdl::Node>& items,
                                      Names& names);

}

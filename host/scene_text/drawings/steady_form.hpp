#pragma once

#include "host/art/geometry/drawing.hpp"

#include <span>

namespace kfast::scene_text {

/// The compiler leaves out segments that have no length, and takes an outline that ends where it begins as
/// closed. Lets all drawings keep their segments, so that they tween point by point: such points are moved by
/// 1/16 px or, where several coincide, by that from each other, along what is drawn there. All coordinates
/// are multiples of 1/16 px. Gaps that close in some drawings get a line in all of the same form.
void keep_segments(std::span<art::Drawing* const> drawings);

/// Moves the ends of outlines that are not closed off their beginnings.
void keep_open(art::Drawing& drawing);

}

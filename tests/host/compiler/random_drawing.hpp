#pragma once

#include "host/scene/model.hpp"
#include "tests/host/compiler/dice.hpp"

#include <vector>

namespace kfast::test {

/// From −100 to 200 px.
scene::Point random_point(Dice& dice);
std::vector<scene::Point> random_points(Dice& dice, int count);

/// A line or a curve.
scene::Segment random_segment(Dice& dice);

/// Strokes of up to five segments, some of them closed.
scene::Drawing random_drawing(Dice& dice, int strokes);
scene::Drawing random_drawing(Dice& dice);

/// One stroke of curves within 60 px of the origin.
scene::Drawing random_curves(Dice& dice);

}

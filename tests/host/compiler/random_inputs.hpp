#pragma once

#include "host/scene/model.hpp"
#include "tests/host/compiler/dice.hpp"

namespace kfast::test {

/// Gives names to the inputs that `scene` has, which are texts, adds numbers and drawings, and lets keys and
/// objects go by them. For a scene that has all else.
void add_random_inputs(Dice& dice, scene::Scene& scene);

}

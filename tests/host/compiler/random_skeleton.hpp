#pragma once

#include "host/scene/model.hpp"
#include "tests/host/compiler/dice.hpp"

#include <vector>

namespace kfast::test {

/// Up to five bones of any place and motion.
std::vector<scene::Bone> random_bones(Dice& dice);

/// The same within 300 px, so that nothing is held at the limits of coordinates; with even or softened speed.
std::vector<scene::Bone> moderate_bones(Dice& dice);

}

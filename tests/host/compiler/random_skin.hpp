#pragma once

#include "host/scene/model.hpp"
#include "tests/host/compiler/dice.hpp"

#include <vector>

namespace kfast::test {

/// Binds the points of `first` to bones of `skeletons[skeleton]`, neighbours often alike.
scene::Skin random_skin(Dice& dice, const std::vector<scene::Bones>& skeletons, std::size_t skeleton,
                        const scene::Drawing& first);

}

#pragma once

#include "host/scene/model.hpp"
#include "tests/host/compiler/dice.hpp"

namespace kfast::test {

/// With colours and skeletons of `scene`; if it shows a text, that is one more of its inputs, without a name.
scene::Object random_object(Dice& dice, scene::Scene& scene);

}

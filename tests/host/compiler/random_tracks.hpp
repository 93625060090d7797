#pragma once

#include "host/scene/model.hpp"
#include "tests/host/compiler/dice.hpp"

#include <vector>

namespace kfast::test {

/// Of an item that is `object`, or of one that is none (null); `colours` of them are in the palette.
std::vector<scene::Track> random_tracks(Dice& dice, const scene::Object* object, std::size_t colours);

}

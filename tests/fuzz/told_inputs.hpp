#pragma once

#include "core/pose/scene_state.hpp"

#include <cstdint>

namespace kfast::test {

/// Tells all inputs of the scene something else in each round: numbers anywhere in their ranges, texts longer
/// than any may be, drawings with points from anywhere, now more and now fewer than there may be.
void tell_inputs(SceneState& state, std::uint32_t round);

}

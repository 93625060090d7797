#pragma once

#include "host/scene/model.hpp"

#include <random>

namespace kfast::test {

/// A scene with anything that a scene can have, small enough for the format in most cases.
scene::Scene random_scene(std::mt19937& random);

/// A scene of one object, whose drawings have curves and no more than 60 px, and of the skeleton that carries
/// it; bones turn and stretch by anything, with even or softened speed.
scene::Scene random_deformed_scene(std::mt19937& random);

}

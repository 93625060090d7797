#pragma once

#include "host/scene/model.hpp"

#include <random>

namespace kfast::test {

/// A scene with anything that a scene can have, small enough for the format in most cases.
scene::Scene random_scene(std::mt19937& random);

}

#pragma once

#include "host/scene_file.hpp"

#include <string>

namespace kfast {

/// "1234 bytes, 60 frames, 5 objects, 4120 bytes of memory at 240x240"
std::string summary(const SceneFile& scene);

}

#pragma once

#include "host/scene_file.hpp"

#include <string>

namespace kfast {

/// "1234 bytes, 60 frames, 5 objects".
std::string contents_summary(const SceneFile& scene);
/// "1234 bytes, 60 frames, 5 objects, 4120 bytes of memory at 240x240": on a panel like the canvas.
std::string summary(const SceneFile& scene);

}

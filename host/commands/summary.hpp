#pragma once

#include "core/size.hpp"
#include "host/scene_file.hpp"

#include <cstddef>
#include <string>

namespace kfast {

/// "1234 bytes, 60 frames, 5 objects, 4120 bytes of memory at 240x240": on a panel like the canvas.
std::string summary(const SceneFile& scene);
/// With the bytes of a block for another panel.
std::string summary(const SceneFile& scene, Size panel, std::size_t block_bytes);

}

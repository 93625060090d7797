#pragma once

#include "core/scene_view.hpp"
#include "firmware/board_settings.hpp"

#include <string>
#include <vector>

namespace kfast {

/// The clips that settings name and a scene does not have, each once by name, in words: a board plays the whole scene
/// in their place.
std::vector<std::string> missing_clips(const BoardSettings& settings, const SceneView& scene);

}

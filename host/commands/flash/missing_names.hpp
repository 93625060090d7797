#pragma once

#include "core/scene/scene_view.hpp"
#include "firmware/settings/board_settings.hpp"

#include <string>
#include <vector>

namespace kfast {

/// The clips and inputs that settings name and a scene does not have, each once by name, in words: in place
/// of such a clip a board plays the whole scene, and a control for such an input does nothing.
std::vector<std::string> missing_names(const BoardSettings& settings, const SceneView& scene);

}

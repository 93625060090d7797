#pragma once

#include "core/scene/scene_view.hpp"
#include "host/compile/scene_file.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace kfast {

/// Of all clips that a scene has, in its order. They live as long as the scene's bytes.
std::vector<std::string_view> clip_names(const SceneView& scene);

/// "60 frames", "2.5 frames": how long a scene is, as its text says (frames=). One that plays once shows its
/// end as well, which is one picture more.
std::string length_text(const SceneView& scene);
/// "1234 bytes, 60 frames, 5 objects".
std::string contents_summary(const SceneFile& scene);
/// "1234 bytes, 60 frames, 5 objects, 4120 bytes of memory at 240x240": on a panel like the canvas.
std::string summary(const SceneFile& scene);

}

#pragma once

#include "host/compile/scene_file.hpp"

#include <nlohmann/json.hpp>
#include <ostream>

namespace kfast {

/// What moves in the skeletons of bones of `scene`, each bone in the frame of its parent:
///
///     [{"skeleton": 1, "bones": [{"bone": 1, "tracks": […]}, {"bone": 2, "parent": 1, "tracks": […]}]}]
///
/// What has a name has that as "name" besides. Tracks are as those of track_facts(), of "angle" in degrees
/// and "x", "y", "length" in pixels.
nlohmann::ordered_json bone_tracks(const SceneFile& scene);

/// The same as lines.
void print_bone_tracks(const nlohmann::ordered_json& facts, std::ostream& out);

}

#pragma once

#include "host/compile/scene_file.hpp"

#include <nlohmann/json.hpp>
#include <ostream>

namespace kfast {

/// What moves in `scene`: all items in their order, with the contents of groups, and those of the symbols.
///
///     {"items": [{"item": "group 1", "tracks": […], "items": [{"item": "object 1.1", "tracks": […]}]},
///                {"item": "use 2", "symbol": 1, "tracks": […]}],
///      "symbols": [{"symbol": 1, "items": […]}]}
///
/// What has a name has that as "name" besides. Tracks are those of track_facts(), that of a path with its
/// "length" in pixels and whether the item rotates
/// ("turn").
nlohmann::ordered_json item_tracks(const SceneFile& scene);

/// The same as lines, deeper with each group.
void print_item_tracks(const nlohmann::ordered_json& facts, std::ostream& out);

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

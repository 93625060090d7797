#pragma once

#include "core/scene/scene_view.hpp"
#include "core/scene/track_view.hpp"

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace kfast {

/// A track of `scene` in the words and units of the scene language:
///
///     {"property": "y", "value": 5}
///     {"property": "y", "smooth": true, "keys": [{"at": 0, "value": 40}, {"at": 15, "value": 200}]}
///     {"property": "y", "smooth": false, "keys": [{"at": 0, "value": 40, "law": "hold"}, …]}
///
/// A last key has no law, nor have values that jump.
nlohmann::ordered_json track_facts(const SceneView& scene, const TrackView& track);

/// "5", "smooth: 0 40, 15 200", "accelerate: 0 40, 15 200", or with laws that differ "0 40 hold, 15 200
/// accelerate, 30 40"; `facts` are those of a track. Of more than most_listed keys, the first and how many
/// more.
std::string track_text(const nlohmann::ordered_json& facts);

/// Adds what is no time of the scene: the name of an input as "input", or the index of a clock as "clock".
void add_driver(const SceneView& scene, Driver driver, nlohmann::ordered_json& facts);
/// Adds the name at that place as "name", if there is one.
void add_name(const std::vector<std::string>& names, std::size_t place, nlohmann::ordered_json& facts);
/// The text after the number of what has such a name: ` "torso"`; empty without one.
std::string name_behind(const nlohmann::ordered_json& facts);

}

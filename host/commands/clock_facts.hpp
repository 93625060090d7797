#pragma once

#include "core/scene_view.hpp"

#include <nlohmann/json.hpp>

namespace kfast {

/// A moment of keys as an author writes it: in frames, or in the values of the input that they go by.
double written_moment(const SceneView& scene, Clock clock, Time moment);

/// Puts the name of the input that `clock` is, if it is one, into facts["input"].
void tell_input(const SceneView& scene, Clock clock, nlohmann::ordered_json& facts);

}

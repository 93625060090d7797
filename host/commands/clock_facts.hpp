#pragma once

#include "host/written_moment.hpp"

#include <nlohmann/json.hpp>

namespace kfast {

/// Puts the name of the input that `clock` is, if it is one, into facts["input"].
void tell_input(const SceneView& scene, Clock clock, nlohmann::ordered_json& facts);

}

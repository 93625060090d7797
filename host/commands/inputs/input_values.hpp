#pragma once

#include "host/commands/inputs/drawing_options.hpp"
#include "host/commands/inputs/input_options.hpp"

#include <vector>

namespace kfast {

/// What all inputs of a scene are.
struct InputValues {
    std::vector<InputValue> values; ///< one for each input
    std::vector<DrawingValue> drawings;
};

/// As chosen by --input and --drawing. Throws as chosen_inputs() and chosen_drawings().
InputValues chosen_values(const InputOptions& inputs, const DrawingOptions& drawings, const SceneView& scene);
/// Applies them to `receiver`. Throws as put_drawings().
void put_values(const InputValues& values, const SceneView& scene, InputReceiver& receiver);

}

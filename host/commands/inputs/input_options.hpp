#pragma once

#include "core/scene/scene_view.hpp"
#include "host/picture/input_receiver.hpp"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

namespace kfast {

/// What numbers and texts among the inputs of a scene are, as chosen by --input NAME=VALUE.
struct InputOptions {
    std::vector<std::string> texts; ///< as they are written
};

/// What one input is.
struct InputValue {
    std::int32_t number = 0; ///< in 1/1000
    std::string text = {};   ///< only of a text; UTF-8
};

/// Adds the option to `app`. `options` must outlive its parsing.
void declare_input_options(CLI::App& app, InputOptions& options);

/// Throws CLI::ValidationError if one of InputOptions::texts names an input that the scene has not.
void require_input(const std::string& text, const SceneView& scene);

/// The value of each input of the scene: as chosen, else the usual one; of a drawing, nothing. Throws
/// CLI::ValidationError for an input that the scene has not, and for a value that it does not take.
std::vector<InputValue> chosen_inputs(const InputOptions& options, const SceneView& scene);

/// Applies them to `receiver`.
void put_inputs(const std::vector<InputValue>& values, const SceneView& scene, InputReceiver& receiver);

}

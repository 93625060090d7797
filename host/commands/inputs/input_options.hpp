#pragma once

#include "core/scene/scene_view.hpp"
#include "host/picture/frame_source.hpp"
#include "host/player/received_drawing.hpp"

#include <CLI/CLI.hpp>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace kfast {

/// The names of all inputs of this type, in the scene's order. They live as long as the scene's bytes.
std::vector<std::string_view> input_names(const SceneView& scene, InputType type);

/// The position of the sign in NAME=WHAT; npos if there is none. Names may have one as well, and so may what
/// follows: the one after the longest name of an input that fits, else the last one.
std::size_t end_of_input_name(std::string_view text, const SceneView& scene);

/// The values of the numbers and texts among the inputs of a scene, as chosen by --input NAME=VALUE.
struct InputOptions {
    std::vector<std::string> texts; ///< as they are written
};

/// The value of one input.
struct InputValue {
    std::int32_t number = 0; ///< in 1/1000
    std::string text = {};   ///< only of a text; UTF-8
};

/// Adds the option to `app`. `options` must outlive its parsing.
void declare_input_options(CLI::App& app, InputOptions& options);

/// Throws CLI::ValidationError if one of InputOptions::texts names an input that the scene does not have.
void require_input(const std::string& text, const SceneView& scene);

/// The value of each input of the scene: as chosen, else the default; of a drawing, nothing. Throws
/// CLI::ValidationError for an input that the scene does not have, and for a value that it does not take.
std::vector<InputValue> chosen_inputs(const InputOptions& options, const SceneView& scene);

/// Applies them to `receiver`.
void put_inputs(const std::vector<InputValue>& values, const SceneView& scene, InputReceiver& receiver);

/// What the drawings among the inputs of a scene are set to, as chosen by --drawing NAME=FILE.
struct DrawingOptions {
    std::vector<std::string> texts; ///< as they are written
};

/// The value of one of them.
struct DrawingValue {
    std::uint32_t number = 0; ///< of the input
    ReceivedDrawing drawing;
    std::string file; ///< where it was read from
};

/// Adds the option to `app`. `options` must outlive its parsing.
void declare_drawing_options(CLI::App& app, DrawingOptions& options);

/// The file of one of DrawingOptions::texts. Throws CLI::ValidationError if none is named.
std::filesystem::path drawing_file(const std::string& text, const SceneView& scene);
/// Throws CLI::ValidationError if one of DrawingOptions::texts names a drawing that the scene does not have.
void require_drawing(const std::string& text, const SceneView& scene);

/// Reads the files, each once. Throws CLI::ValidationError for a drawing that the scene does not have and for
/// what is no drawing, and Failure for a file that cannot be read.
std::vector<DrawingValue> chosen_drawings(const DrawingOptions& options, const SceneView& scene);

/// Applies them to `receiver`. Throws CLI::ValidationError for one that has too much.
void put_drawings(const std::vector<DrawingValue>& drawings, const SceneView& scene, InputReceiver& receiver);

/// The values of all inputs of a scene.
struct InputValues {
    std::vector<InputValue> values; ///< one for each input
    std::vector<DrawingValue> drawings;
};

/// As chosen by --input and --drawing. Throws as chosen_inputs() and chosen_drawings().
InputValues chosen_values(const InputOptions& inputs, const DrawingOptions& drawings, const SceneView& scene);
/// Applies them to `receiver`. Throws as put_drawings().
void put_values(const InputValues& values, const SceneView& scene, InputReceiver& receiver);

}

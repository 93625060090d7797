#pragma once

#include "core/scene/scene_view.hpp"
#include "host/picture/input_receiver.hpp"
#include "host/player/received_drawing.hpp"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace kfast {

/// What the drawings among the inputs of a scene are set to, as chosen by --drawing NAME=FILE.
struct DrawingOptions {
    std::vector<std::string> texts; ///< as they are written
};

/// What one of them is.
struct DrawingValue {
    std::uint32_t number = 0; ///< of the input
    ReceivedDrawing drawing;
    std::string file; ///< where it stood
};

/// Adds the option to `app`. `options` must outlive its parsing.
void declare_drawing_options(CLI::App& app, DrawingOptions& options);

/// Of one of DrawingOptions::texts, the file. Throws CLI::ValidationError if none is named.
std::filesystem::path drawing_file(const std::string& text, const SceneView& scene);
/// Throws CLI::ValidationError if one of DrawingOptions::texts names a drawing that the scene has not.
void require_drawing(const std::string& text, const SceneView& scene);

/// Reads the files, each once. Throws CLI::ValidationError for a drawing that the scene has not and for what
/// is no drawing, and Failure for a file that cannot be read.
std::vector<DrawingValue> chosen_drawings(const DrawingOptions& options, const SceneView& scene);

/// Applies them to `receiver`. Throws CLI::ValidationError for one that has too much.
void put_drawings(const std::vector<DrawingValue>& drawings, const SceneView& scene, InputReceiver& receiver);

}

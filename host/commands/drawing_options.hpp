#pragma once

#include "core/scene_view.hpp"
#include "host/picture/told_inputs.hpp"

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace kfast {

/// What the drawings among the inputs of a scene are told, as chosen by --drawing NAME=FILE.
struct DrawingOptions {
    std::vector<std::string> texts; ///< as they are written
};

/// Adds the option to `app`. `options` must outlive its parsing.
void declare_drawing_options(CLI::App& app, DrawingOptions& options);

/// Tells them to `told`. Throws CLI::ValidationError for a drawing that the scene has not, that is no
/// drawing, or that has too much, and Failure for a file that cannot be read.
void put_drawings(const DrawingOptions& options, const SceneView& scene, ToldInputs& told);

}

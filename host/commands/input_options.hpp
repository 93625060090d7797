#pragma once

#include "core/scene_view.hpp"
#include "host/picture/frame_source.hpp"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

namespace kfast {

/// Where the numbers among the inputs of a scene stand, as chosen by --input NAME=VALUE.
struct InputOptions {
    std::vector<std::string> texts; ///< as they are written
};

/// Adds the option to `app`. `options` must outlive its parsing.
void declare_input_options(CLI::App& app, InputOptions& options);

/// The value of each input of the scene, in 1/1000: as chosen, else the usual one; 0 of what is no number.
/// Throws CLI::ValidationError for a number that the scene has not, and for a value that is not within its
/// range.
std::vector<std::int32_t> chosen_inputs(const InputOptions& options, const SceneView& scene);

/// Puts them into `source`.
void put_inputs(const std::vector<std::int32_t>& values, const SceneView& scene, FrameSource& source);

}

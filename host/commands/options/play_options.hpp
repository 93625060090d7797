#pragma once

#include "host/picture/timeline.hpp"

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace kfast {

/// What of a scene is played and how fast, as chosen by --clip and --speed.
struct PlayOptions {
    std::optional<std::string> clip; ///< none: the whole scene
    std::int32_t speed = Playhead::as_authored;
};

/// Adds both options to `app`. `options` must outlive its parsing.
void declare_play_options(CLI::App& app, PlayOptions& options);

/// Throws CLI::ValidationError for a clip that the scene does not have.
Timeline chosen_timeline(const PlayOptions& options, const SceneView& scene);
/// Throws CLI::ValidationError if the scene does not have the clip.
void require_clip(const std::string& name, const SceneView& scene);

}

#pragma once

#include "core/player.hpp"
#include "host/picture/panel_choice.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

namespace kfast {

/// What a scene is drawn on, as chosen by --size, --fit, --format and --panel.
struct PictureOptions {
    std::optional<Size> size; ///< none: the canvas of the scene
    Fit fit = Fit::contain;
    PixelFormat format = PixelFormat::rgb565;
    const PanelChoice* panel = nullptr; ///< instead of size and format
};

/// Adds the four options to `app`. `options` must outlive its parsing.
void declare_picture_options(CLI::App& app, PictureOptions& options);

/// Adds --size and --panel only.
void declare_size_options(CLI::App& app, PictureOptions& options);

Size panel_size(const PictureOptions& options, const SceneView& scene);

/// `scene`'s bytes must outlive the source.
std::unique_ptr<FrameSource> open_source(const PictureOptions& options, const SceneView& scene);

}

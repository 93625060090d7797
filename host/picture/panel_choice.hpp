#pragma once

#include "core/player.hpp"
#include "host/picture/frame_source.hpp"

#include <memory>
#include <span>
#include <string_view>

namespace kfast {

/// A display that can be named on the command line.
struct PanelChoice {
    std::string_view name;
    Size size;
    PixelFormat format;
    /// `scene`'s bytes must outlive the source.
    std::unique_ptr<FrameSource> (*open)(const SceneView& scene, Fit fit);
};

std::span<const PanelChoice> panel_choices();

}

#pragma once

#include "host/picture/frame_source.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <string_view>

namespace kfast {

/// A display that can be named on the command line.
struct PanelChoice {
    std::string_view name;
    Size size;
    /// `scene` is a checked scene and must outlive the source.
    std::unique_ptr<FrameSource> (*open)(std::span<const std::byte> scene);
};

std::span<const PanelChoice> panel_choices();

}

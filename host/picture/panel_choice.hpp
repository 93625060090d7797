#pragma once

#include "core/pixel/pixel_format.hpp"
#include "firmware/settings/panel_settings.hpp"

#include <span>
#include <string_view>

namespace kfast {

/// The name of a format of pixels on the command line and in descriptions of boards.
struct FormatName {
    std::string_view name;
    PixelFormat value;
};

std::span<const FormatName> format_names();

/// A display that can be named on the command line: the default module of a controller.
struct PanelChoice {
    std::string_view name;
    PanelSettings settings;
};

std::span<const PanelChoice> panel_choices();

}

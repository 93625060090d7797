#pragma once

#include "firmware/settings/panel_settings.hpp"

#include <span>
#include <string_view>

namespace kfast {

/// A display that can be named on the command line: the usual module of a controller.
struct PanelChoice {
    std::string_view name;
    PanelSettings settings;
};

std::span<const PanelChoice> panel_choices();

}

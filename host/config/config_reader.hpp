#pragma once

#include "firmware/settings/board_settings.hpp"
#include "host/text/diagnostic.hpp"
#include "host/text/source.hpp"

#include <optional>

namespace kfast::config {

/// Reads the settings of a board (docs/config.md). Any text is allowed; what is wrong goes to `diagnostics`,
/// and there are settings exactly when nothing was. They keep all rules of firmware/settings/board_rules.hpp;
/// a clock above what the display is rated for is only warned of.
std::optional<BoardSettings> read_config(const SourceText& source, Diagnostics& diagnostics);

}

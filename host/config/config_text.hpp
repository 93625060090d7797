#pragma once

#include "firmware/settings/board_settings.hpp"
#include "host/text/diagnostic.hpp"
#include "host/text/source.hpp"

#include <optional>
#include <string>

namespace kfast::config {

/// Reads the settings of a board (docs/config.md). Any text is allowed; what is wrong goes to `diagnostics`,
/// and there are settings exactly when nothing was. They keep all rules of firmware/settings/board_rules.hpp;
/// a clock above what the display is rated for is only warned of.
std::optional<BoardSettings> read_config(const SourceText& source, Diagnostics& diagnostics);

/// Settings as a text that read_config() reads as the same ones, if they keep the rules: every field is
/// there, with comments. The controls are written without gaps. What the rules forbid is written as it is.
std::string config_text(const BoardSettings& settings);

}

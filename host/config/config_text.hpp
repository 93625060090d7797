#pragma once

#include "firmware/settings/board_settings.hpp"

#include <string>

namespace kfast::config {

/// Settings as a text that read_config() reads as the same ones, if they keep the rules: every field is
/// there, with comments. The controls come without gaps. What the rules forbid is written as it is.
std::string config_text(const BoardSettings& settings);

}

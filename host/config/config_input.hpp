#pragma once

#include "firmware/settings/board_settings.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace kfast::config {

/// The settings that `input` names: a configuration of this program; a text; or a record
/// (firmware/settings/board_record.hpp), at the beginning of a file, in its place in an image of the whole
/// flash, or in a UF2 file. Names have neither dot nor slash; what a file is, its content tells.
///
/// What is wrong with a text is printed to standard error, and what a person should know although it is not.
/// Throws Failure for a name that there is not, a file that holds no settings, and settings that break a
/// rule.
BoardSettings chosen_settings(const std::string& input);

/// As they lie in flash: a sector, padded with 0xFF.
std::vector<std::byte> settings_sector(const BoardSettings& settings);

}

#pragma once

#include "firmware/settings/board_settings.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace kfast::config {

/// The settings that `input` names: a configuration of this program; a text; or a record
/// (firmware/settings/board_record.hpp), at the beginning of a file, in its place in an image of the whole
/// flash, or in a UF2 file. Names have neither dot nor slash; the kind of a file is detected by its content.
///
/// What is wrong with a text is printed to standard error, and what a person should know although it is not.
/// Throws Failure for a name that does not exist, a file that holds no settings, and settings that break a
/// rule.
BoardSettings chosen_settings(const std::string& input);

/// The settings as they are in flash: a sector, padded with 0xFF.
std::vector<std::byte> settings_sector(const BoardSettings& settings);

}

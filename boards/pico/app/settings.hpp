#pragma once

#include "firmware/settings/board_rules.hpp"

#include <optional>

namespace kfast::pico {

/// The settings that flash holds, or the default ones for the bus if their place is blank. Nothing if what
/// is there is no record that this image can read: then it is not known how the board is wired. Stored ones
/// may be for another bus and may break any rule (board_rules.hpp).
std::optional<BoardSettings> settings_for(BusKind bus);

/// As first_mistake(), from flash, where it takes no RAM.
MaybeMistake mistake_in(const BoardSettings& settings);

}

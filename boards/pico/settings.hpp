#pragma once

#include "firmware/board_settings.hpp"

namespace kfast::pico {

/// The settings that flash holds, or the default ones for the bus if it holds none. Stored ones may be for
/// another bus and may break any rule (board_rules.hpp).
BoardSettings settings_for(BusKind bus);

}

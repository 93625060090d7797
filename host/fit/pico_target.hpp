#pragma once

#include "firmware/settings/board_settings.hpp"
#include "host/fit/target.hpp"

namespace kfast::fit {

/// A Raspberry Pi Pico with the display, or the beam, and the bus of these settings.
Target pico_target(const BoardSettings& settings);

}

#pragma once

#include "firmware/settings/board_settings.hpp"
#include "host/fit/target.hpp"

#include <iostream>
#include <string>

namespace kfast::fit {

/// Whether the name is that of a file that describes a board: it has a dot or a slash.
bool names_board_file(const std::string& name);

/// The board of that name, or that the file of this name describes. Mistakes in a file are printed
/// to `out`.
/// Throws Failure for a name that no board has and for a file that describes none.
Target chosen_board(const std::string& name, std::ostream& out = std::cerr);

/// A Raspberry Pi Pico with the display, or the beam, and the bus of these settings.
Target pico_target(const BoardSettings& settings);

}

#pragma once

#include "host/simulator/plugged_board.hpp"

namespace kfast {

/// Runs a simulated board until its onlooker has seen enough. Throws Failure for what the firmware does wrong
/// on the wires of the display.
void run_plugged_board(const PluggedParts& parts);

}

#pragma once

#include "firmware/settings/board_settings.hpp"

#include <map>

namespace kfast::test {

/// Pins as a test sets them.
struct PretendPins {
    bool pressed(Pin pin) { return closed[pin]; }
    int level(Pin pin) { return levels[pin]; }

    std::map<Pin, bool> closed;
    std::map<Pin, int> levels;
};

}

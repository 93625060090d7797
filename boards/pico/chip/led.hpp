#pragma once

/// The light on the board: GPIO 25.
namespace kfast::pico::led {

/// Dark. Needs start_clocks().
void begin();
void toggle();

}

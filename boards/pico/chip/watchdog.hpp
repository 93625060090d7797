#pragma once

/// Resets the chip unless it is fed for 8.3 seconds. Needs the tick of start_clocks().
namespace kfast::pico::watchdog {

void start();
void feed();
/// Reboots now, from the boot ROM on.
[[noreturn]] void reboot();

}

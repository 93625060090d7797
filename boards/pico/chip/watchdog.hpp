#pragma once

#include <cstdint>

/// Resets the chip unless it is fed for 8.3 seconds. Needs the tick of start_clocks().
namespace kfast::pico::watchdog {

/// Whether the chip has started because the watchdog was not fed; also after the boot loader, which uses the
/// watchdog to start the firmware.
bool has_restarted();
/// A word that stays as it is whenever the watchdog restarts the chip. It is 0 when the power comes on.
std::uint32_t kept();
void keep(std::uint32_t word);

void start();
void feed();
/// Reboots now, from the boot ROM on.
[[noreturn]] void reboot();

}

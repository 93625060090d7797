#include "boards/pico/chip/watchdog.hpp"

#include "boards/pico/chip/register.hpp"

#include <cstdint>

namespace kfast::pico::watchdog {
namespace {

// WATCHDOG
constexpr Register ctrl{0x4005'8000};
constexpr Register load{0x4005'8004};
constexpr Register reason{0x4005'8008};
// The boot ROM uses 0 and 1 to become a drive, and 4 to 7 to start what lies in flash or RAM.
constexpr Register scratch3{0x4005'8018};
// PAUSE_JTAG, PAUSE_DBG0, PAUSE_DBG1: it stands still for a debugger.
constexpr std::uint32_t ctrl_pause = 7 << 24;
constexpr std::uint32_t ctrl_enable = 1 << 30;
constexpr std::uint32_t ctrl_trigger = 1U << 31;

constexpr std::uint32_t reason_timer = 1 << 0;

// The counter falls by two at every tick of a microsecond (erratum RP2040-E1).
constexpr std::uint32_t longest = 0xFF'FFFF;
static_assert(longest / 2 > 8'300'000);

// What the watchdog resets: all but the oscillators, which go on swinging.
constexpr Register psm_wdsel{0x4001'0008};
constexpr std::uint32_t all_but_oscillators = 0x1'FFFC;

}

void start()
{
    ctrl.clear(ctrl_enable);
    psm_wdsel.set(all_but_oscillators);
    feed();
    ctrl.set(ctrl_enable | ctrl_pause);
}

bool has_restarted() { return (reason.read() & reason_timer) != 0; }

std::uint32_t kept() { return scratch3.read(); }

void keep(std::uint32_t word) { scratch3.write(word); }

void feed() { load.write(longest); }

void reboot()
{
    psm_wdsel.set(all_but_oscillators);
    ctrl.set(ctrl_trigger);
    while (true)
        asm volatile("wfe");
}

}

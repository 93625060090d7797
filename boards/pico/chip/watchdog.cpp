#include "boards/pico/chip/watchdog.hpp"

#include "boards/pico/chip/register.hpp"

#include <cstdint>

namespace kfast::pico::watchdog {
namespace {

constexpr Register control{0x4005'8000};
constexpr Register load{0x4005'8004};
constexpr std::uint32_t stand_still_for_debugger = 7 << 24;
constexpr std::uint32_t enable = 1 << 30;
constexpr std::uint32_t trigger = 1U << 31;

// The counter falls by two at every tick of a microsecond (erratum RP2040-E1).
constexpr std::uint32_t longest = 0xFF'FFFF;
static_assert(longest / 2 > 8'300'000);

// What the watchdog resets: all but the oscillators, which go on swinging.
constexpr Register reset_by_watchdog{0x4001'0008};
constexpr std::uint32_t all_but_oscillators = 0x1'FFFC;

}

void start()
{
    control.clear(enable);
    reset_by_watchdog.set(all_but_oscillators);
    feed();
    control.set(enable | stand_still_for_debugger);
}

void feed() { load.write(longest); }

void reboot()
{
    reset_by_watchdog.set(all_but_oscillators);
    control.set(trigger);
    while (true)
        asm volatile("wfe");
}

}

#include "boards/pico/chip/clock.hpp"

#include "boards/pico/chip/interrupts.hpp"
#include "boards/pico/chip/register.hpp"
#include "boards/pico/chip/resets.hpp"
#include "boards/pico/chip/watchdog.hpp"

#include <cstdint>

namespace kfast::pico {
namespace {

// TIMER
constexpr Register timer_alarm0{0x4005'4010};
constexpr Register timerawl{0x4005'4028};
constexpr Register timer_intr{0x4005'4034};
constexpr Register timer_inte{0x4005'4038};
constexpr std::uint32_t alarm_0 = 1 << 0; // in INTR and INTE

constexpr Microseconds longest_sleep{1'000'000}; // so that the watchdog is fed

}

void Clock::begin()
{
    resets::release(resets::timer);
    timer_inte.set(alarm_0);
    enable(Interrupt::timer_irq_0);
}

Microseconds Clock::now() const { return {timerawl.read()}; }

void Clock::sleep_until(Microseconds moment) const
{
    watchdog::feed();
    while (!reached(now(), moment))
        doze_until(moment);
}

void Clock::doze_until(Microseconds moment) const
{
    const Microseconds start = now();
    if (reached(start, moment))
        return;
    const Microseconds end = (moment - start).count > longest_sleep.count ? start + longest_sleep : moment;
    timer_alarm0.write(end.count);
    // The alarm rings only if the time is yet to come. An interrupt that comes before the processor sleeps
    // ends the sleep as well (WFE, not WFI).
    if (!reached(now(), end))
        asm volatile("wfe");
    watchdog::feed();
}

extern "C" void timer_0_handler() { timer_intr.write(alarm_0); }

}

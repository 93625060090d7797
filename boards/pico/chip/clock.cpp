#include "boards/pico/chip/clock.hpp"

#include "boards/pico/chip/interrupts.hpp"
#include "boards/pico/chip/register.hpp"
#include "boards/pico/chip/resets.hpp"
#include "boards/pico/chip/watchdog.hpp"

#include <cstdint>

namespace kfast::pico {
namespace {

constexpr Register timer_alarm_0{0x4005'4010};
constexpr Register timer_low{0x4005'4028};
constexpr Register timer_raised{0x4005'4034};
constexpr Register timer_enable{0x4005'4038};
constexpr std::uint32_t alarm_0 = 1 << 0;

constexpr Microseconds longest_sleep{1'000'000}; // so that the watchdog is fed

}

void Clock::begin()
{
    resets::release(resets::timer);
    timer_enable.set(alarm_0);
    enable(Interrupt::timer_0);
}

Microseconds Clock::now() const { return {timer_low.read()}; }

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
    timer_alarm_0.write(end.count);
    // The alarm rings only if the time is yet to come. An interrupt that comes before the processor sleeps
    // ends the sleep as well (WFE, not WFI).
    if (!reached(now(), end))
        asm volatile("wfe");
    watchdog::feed();
}

extern "C" void timer_0_handler() { timer_raised.write(alarm_0); }

}

#include "boards/pico/clock.hpp"

#include "boards/pico/interrupts.hpp"
#include "boards/pico/register.hpp"
#include "boards/pico/resets.hpp"
#include "boards/pico/watchdog.hpp"

#include <cstdint>

namespace kfast::pico {
namespace {

constexpr Register timer_alarm_0{0x4005'4010};
constexpr Register timer_low{0x4005'4028};
constexpr Register timer_raised{0x4005'4034};
constexpr Register timer_enable{0x4005'4038};
constexpr std::uint32_t alarm_0 = 1 << 0;

constexpr Microseconds longest_sleep{1'000'000}; // so that the watchdog is fed

/// Until an interrupt, of the timer at `moment` at the latest. One that comes before the processor sleeps
/// ends the sleep as well (WFE, not WFI).
void doze_until(Microseconds moment, const Clock& clock)
{
    timer_alarm_0.write(moment.count);
    if (!reached(clock.now(), moment)) // the alarm rings only if the time is yet to come
        asm volatile("wfe");
}

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
    while (!reached(now(), moment)) {
        const Microseconds left = moment - now();
        doze_until(left.count > longest_sleep.count ? now() + longest_sleep : moment, *this);
        watchdog::feed();
    }
}

extern "C" void timer_0_handler() { timer_raised.write(alarm_0); }

}

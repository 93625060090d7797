#include "boards/vexpress-a9/clock.hpp"

#include "boards/vexpress-a9/registers.hpp"

#include <cstdint>

namespace kfast::vexpress_a9 {
namespace {

constexpr std::uint32_t once = 1 << 0;
constexpr std::uint32_t counts_32_bits = 1 << 1;
constexpr std::uint32_t interrupts = 1 << 5;
constexpr std::uint32_t runs = 1 << 7;

constexpr std::uint32_t highest_value = 0xFFFF'FFFF;

// Number 34 wakes the CPU, which takes no interrupts.
void let_alarm_wake()
{
    gic_cpus_of_32_to_35.set(1 << 16);
    gic_enable_32_to_63.write(1 << 2);
    gic_control.write(1);
    gic_cpu_priority_mask.write(0xFF);
    gic_cpu_control.write(1);
}

}

void Clock::begin()
{
    timer_load.write(highest_value);
    timer_control.write(counts_32_bits | runs); // at its end it begins again with the highest value
    let_alarm_wake();
}

Microseconds Clock::now() const { return {highest_value - timer_value.read()}; }

void Clock::sleep_until(Microseconds moment) const
{
    const Microseconds before = now();
    if (reached(before, moment))
        return;
    alarm_load.write((moment - before).count);
    alarm_control.write(once | counts_32_bits | interrupts | runs);
    while (!reached(now(), moment))
        asm volatile("wfi");
    alarm_control.write(0);
    alarm_clear.write(0);
}

}

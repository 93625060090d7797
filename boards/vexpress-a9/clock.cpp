#include "boards/vexpress-a9/clock.hpp"

#include "boards/vexpress-a9/registers.hpp"

#include <cstdint>

namespace kfast::vexpress_a9 {
namespace {

constexpr std::uint32_t timer_control_one_shot = 1 << 0;
constexpr std::uint32_t timer_control_timer_size = 1 << 1;
constexpr std::uint32_t timer_control_int_enable = 1 << 5;
constexpr std::uint32_t timer_control_timer_en = 1 << 7;

constexpr std::uint32_t highest_value = 0xFFFF'FFFF;

// Number 34 wakes the CPU, which takes no interrupts.
void let_alarm_wake()
{
    gicd_itargetsr8.set(1 << 16);
    gicd_isenabler1.write(1 << 2);
    gicd_ctlr.write(1);
    gicc_pmr.write(0xFF);
    gicc_ctlr.write(1);
}

}

void Clock::begin()
{
    timer1_load.write(highest_value);
    timer1_control.write(timer_control_timer_size |
                         timer_control_timer_en); // at its end it begins again with the highest value
    let_alarm_wake();
}

Microseconds Clock::now() const { return {highest_value - timer1_value.read()}; }

void Clock::sleep_until(Microseconds moment) const
{
    const Microseconds before = now();
    if (reached(before, moment))
        return;
    timer2_load.write((moment - before).count);
    timer2_control.write(timer_control_one_shot | timer_control_timer_size | timer_control_int_enable |
                         timer_control_timer_en);
    while (!reached(now(), moment))
        asm volatile("wfi");
    timer2_control.write(0);
    timer2_int_clr.write(0);
}

}

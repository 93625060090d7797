#pragma once

#include "firmware/chip/cortex_m.hpp"

#include <cstdint>

namespace kfast::pico {

/// The numbers of the chip's interrupts, as its vector table (start.cpp) has them.
enum class Interrupt : std::uint32_t {
    timer_irq_0 = 0,
    usbctrl_irq = 5,
    io_irq_bank0 = 13,
    uart0_irq = 20,
    uart1_irq = 21,
    i2c0_irq = 23,
    i2c1_irq = 24
};

inline void enable(Interrupt interrupt)
{
    cortex_m::nvic_iser0.write(1u << static_cast<std::uint32_t>(interrupt));
}

/// While it lives no interrupt is served; those that come wait. Memory is then what the program last wrote.
class InterruptsOff {
public:
    InterruptsOff() { asm volatile("mrs %0, primask\n cpsid i" : "=r"(before_) : : "memory"); }
    ~InterruptsOff() { asm volatile("msr primask, %0" : : "r"(before_) : "memory"); }
    InterruptsOff(const InterruptsOff&) = delete;
    InterruptsOff& operator=(const InterruptsOff&) = delete;

private:
    std::uint32_t before_;
};

}

#pragma once

#include "boards/pico/chip/register.hpp"

#include <cstdint>

namespace kfast::pico {

/// The numbers of the chip's interrupts, as its vector table (start.cpp) has them.
enum class Interrupt : std::uint32_t {
    timer_0 = 0,
    usb = 5,
    io_bank0 = 13,
    uart0 = 20,
    uart1 = 21,
    i2c0 = 23,
    i2c1 = 24
};

inline constexpr Register nvic_enable{0xE000'E100}; // a 0 leaves an interrupt as it is

inline void enable(Interrupt interrupt) { nvic_enable.write(1u << static_cast<std::uint32_t>(interrupt)); }

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

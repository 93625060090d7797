#pragma once

#include "firmware/chip/cortex_m.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

extern "C" {
// From the linker script.
extern std::uint32_t data_load[]; // .data in flash
extern std::uint32_t data_begin[];
extern std::uint32_t data_end[];
extern std::uint32_t bss_begin[];
extern std::uint32_t bss_end[];
extern std::uint32_t stack_top[];
}

/// The vector table of a Cortex-M, and what runs before main(). Exceptions have the numbers that IPSR has:
/// 1 is the reset, 3 a hard fault, 15 SysTick, and 16 + n interrupt n of the chip.
namespace kfast::cortex_m {

using Handler = void (*)();

inline constexpr std::size_t reset = 1;
inline constexpr std::size_t systick = 15;
constexpr std::size_t interrupt(std::size_t number) { return 16 + number; }

/// What the processor reads at its start and at every exception, for a chip with `interrupts` of its own. It
/// is in section .vectors, which the linker script places and keeps:
/// `[[gnu::section(".vectors"), gnu::used]] constinit const`. A board that sets VTOR must align the table to
/// a power of two that is no less than its size.
template <std::size_t interrupts>
class VectorTable {
public:
    /// Every exception but the reset goes to `default_handler`.
    constexpr VectorTable(Handler reset_handler, Handler default_handler)
    {
        handlers_.fill(default_handler);
        set(reset, reset_handler);
    }

    /// The same, except that `exception` goes to `handler`.
    constexpr VectorTable with(std::size_t exception, Handler handler) const
    {
        VectorTable table = *this;
        table.set(exception, handler);
        return table;
    }

private:
    constexpr void set(std::size_t exception, Handler handler) { handlers_[exception - 1] = handler; }

    std::uint32_t* stack_ = stack_top;                          ///< where the stack begins
    std::array<Handler, interrupt(interrupts) - 1> handlers_{}; ///< of exceptions 1, 2 …
};

/// The exception that is being handled.
inline std::uint32_t active_exception()
{
    std::uint32_t exception = 0;
    asm volatile("mrs %0, ipsr" : "=r"(exception));
    return exception;
}

/// An FPU is off after a reset, and the compiler keeps integers in it as well. Does nothing if the program is
/// compiled for none. To be called first in a reset handler.
[[gnu::always_inline]] inline void switch_fpu_on()
{
#ifdef __ARM_FP
    cpacr.set(cpacr_fpu);
    asm volatile("dsb\n isb");
#endif
}

/// Gives variables that do not begin with zero their values. It may call memcpy().
[[gnu::always_inline]] inline void copy_data()
{
    std::copy(data_load, data_load + (data_end - data_begin), data_begin);
}

/// Makes all others zero. It calls nothing, if compiled with -fno-tree-loop-distribute-patterns.
[[gnu::always_inline]] inline void clear_bss()
{
    for (std::uint32_t* word = bss_begin; word != bss_end;)
        *word++ = 0;
}

}

#include "firmware/chip/register.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

int main();

extern "C" {

// From the linker script.
extern std::uint32_t data_load[];
extern std::uint32_t data_begin[];
extern std::uint32_t data_end[];
extern std::uint32_t bss_begin[];
extern std::uint32_t bss_end[];
extern std::uint32_t stack_top[];

/// Also what comes of an exception that nobody handles.
[[noreturn]] void stop()
{
    while (true)
        asm volatile("wfi");
}

[[noreturn]] void reset_handler()
{
#ifdef __ARM_FP // an FPU is off after a reset, and the compiler keeps integers in it as well
    constexpr kfast::Register cpacr{0xE000'ED88};
    cpacr.set(0xF << 20);
    asm volatile("dsb\n isb");
#endif
    std::copy(data_load, data_load + (data_end - data_begin), data_begin);
    std::fill(bss_begin, bss_end, 0);
    main();
    stop();
}
}

namespace {

using Handler = void (*)();

constexpr std::size_t cpu_exceptions = 15;
constexpr std::size_t chip_interrupts = 32; // as many as the chip has

struct VectorTable {
    std::uint32_t* stack;
    std::array<Handler, cpu_exceptions + chip_interrupts> handlers;
};

/// Put yours in their places: SysTick is handlers[14], interrupt n of the chip handlers[15 + n].
constexpr auto handlers = [] {
    std::array<Handler, cpu_exceptions + chip_interrupts> table{};
    table.fill(stop);
    table[0] = reset_handler;
    return table;
}();

[[gnu::section(".vectors"), gnu::used]] constinit const VectorTable vectors{stack_top, handlers};

}

#include "boards/lm3s6965evb/uart.hpp"
#include "firmware/chip/cortex_m.hpp"
#include "firmware/serial/console.hpp"

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

void ssi0_handler();
void systick_handler();

[[noreturn]] void stop()
{
    while (true)
        asm volatile("wfi");
}

[[noreturn]] void reset_handler()
{
#ifdef __ARM_FP // without an FPU there is nothing to switch on
    kfast::cortex_m::cpacr.set(kfast::cortex_m::cpacr_fpu);
    asm volatile("dsb\n isb");
#endif
    std::copy(data_load, data_load + (data_end - data_begin), data_begin);
    std::fill(bss_begin, bss_end, 0);
    main();
    stop();
}

/// Any exception that nobody handles: names its number (3 is a hard fault) and stops.
[[noreturn]] void fault_handler()
{
    using namespace kfast;
    std::uint32_t exception = 0;
    asm volatile("mrs %0, ipsr" : "=r"(exception));
    write_text(lm3s6965evb::uart, "FAULT ");
    write_decimal(lm3s6965evb::uart, exception);
    lm3s6965evb::uart.write('\n');
    stop();
}
}

namespace {

using Handler = void (*)();

struct VectorTable {
    std::uint32_t* stack;
    std::array<Handler, 15 + 44> handlers; ///< 15 of the CPU, 44 of the chip
};

constexpr std::array<Handler, 59> handlers = [] {
    std::array<Handler, 59> table{};
    table.fill(fault_handler);
    table[0] = reset_handler;
    table[14] = systick_handler;
    table[15 + 7] = ssi0_handler;
    return table;
}();

[[gnu::section(".vectors"), gnu::used]] constinit const VectorTable vectors{stack_top, handlers};

}

#include "tests/bench/image/harness/painted_stack.hpp"
#include "tests/bench/image/harness/semihosting.hpp"

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

void systick_handler();

[[noreturn]] void reset_handler()
{
#ifdef __ARM_FP // without an FPU there is nothing to switch on
    *reinterpret_cast<volatile std::uint32_t*>(0xE000'ED88) |= 0xF << 20;
    asm volatile("dsb\n isb");
#endif
    std::copy(data_load, data_load + (data_end - data_begin), data_begin);
    std::fill(bss_begin, bss_end, 0);
    kfast::bench::paint_stack();
    kfast::bench::semihosting::exit(main());
}

[[noreturn]] void fault_handler()
{
    kfast::bench::semihosting::write("fault\n");
    kfast::bench::semihosting::exit(99);
}
}

namespace {

using Handler = void (*)();

struct VectorTable {
    std::uint32_t* stack;
    std::array<Handler, 15> handlers;
};

constexpr std::array<Handler, 15> handlers = [] {
    std::array<Handler, 15> table{};
    table.fill(fault_handler);
    table[0] = reset_handler;
    table[14] = systick_handler;
    return table;
}();

[[gnu::section(".vectors"), gnu::used]] constinit const VectorTable vectors{stack_top, handlers};

}

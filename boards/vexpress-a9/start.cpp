#include "boards/vexpress-a9/uart.hpp"
#include "firmware/serial/console.hpp"

#include <algorithm>
#include <cstdint>

int main();

extern "C" {

// From the linker script.
extern std::uint32_t bss_begin[];
extern std::uint32_t bss_end[];

[[noreturn]] void stop()
{
    while (true)
        asm volatile("wfi");
}

[[noreturn, gnu::used]] void start()
{
    std::fill(bss_begin, bss_end, 0);
    main();
    stop();
}

/// Prints the mode that the exception has led to (23: memory that cannot be read, written or run, 27: no
/// instruction) and stops.
[[noreturn, gnu::used]] void report_fault()
{
    using namespace kfast;
    std::uint32_t status = 0;
    asm volatile("mrs %0, cpsr" : "=r"(status));
    write_text(vexpress_a9::uart, "FAULT ");
    write_decimal(vexpress_a9::uart, status & 31);
    vexpress_a9::uart.write('\n');
    stop();
}

/// Where the CPU goes after a reset and, as reset_handler() sets it, with every exception.
[[gnu::naked, gnu::used, gnu::section(".vectors")]] void vectors()
{
    asm volatile("b reset_handler\n"
                 ".rept 7\n"
                 "b fault_handler\n"
                 ".endr");
}

[[gnu::naked, gnu::used]] void reset_handler()
{
    asm volatile("ldr sp, =stack_top\n"
                 "ldr r0, =vectors\n"
                 "mcr p15, 0, r0, c12, c0, 0\n" // the base address of the vectors
                 "b start\n"
                 ".ltorg");
}

/// Each mode has a stack of its own, which has not been set.
[[gnu::naked, gnu::used]] void fault_handler()
{
    asm volatile("ldr sp, =stack_top\n"
                 "b report_fault\n"
                 ".ltorg");
}
}

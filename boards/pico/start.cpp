// The vectors and what runs before main(). Until the code is in RAM nothing may be called, so this is
// compiled with -fno-tree-loop-distribute-patterns: loops stay loops.

#include "boards/pico/app/log.hpp"
#include "boards/pico/chip/interrupts.hpp"
#include "boards/pico/chip/led.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

int main();

extern "C" {

// From the linker script.
extern std::uint32_t code_load[];
extern std::uint32_t code_begin[];
extern std::uint32_t code_end[];
extern std::uint32_t bss_begin[];
extern std::uint32_t bss_end[];
extern std::uint32_t stack_top[];

void fault_handler();

void timer_0_handler();
void usb_handler();
void uart_handler();
// Of what not every image has.
[[gnu::weak]] void make_safe();
[[gnu::weak, gnu::alias("fault_handler")]] void io_bank0_handler() noexcept;
[[gnu::weak, gnu::alias("fault_handler")]] void i2c0_handler() noexcept;
[[gnu::weak, gnu::alias("fault_handler")]] void i2c1_handler() noexcept;

[[noreturn, gnu::section(".start")]] void reset_handler()
{
    const std::uint32_t* from = code_load;
    for (std::uint32_t* to = code_begin; to != code_end;)
        *to++ = *from++;
    for (std::uint32_t* to = bss_begin; to != bss_end;)
        *to++ = 0;
    asm volatile("" ::: "memory");
    main();
    while (true)
        asm volatile("wfe");
}

/// Names the exception (3 is a hard fault, 16 and more are interrupts of the chip) and where it came, and
/// blinks in haste until the watchdog starts everything anew. `frame` is what the processor saved.
[[noreturn, gnu::used]] void report_fault(const std::uint32_t* frame)
{
    using namespace kfast;
    using pico::log;
    if (make_safe != nullptr)
        make_safe();
    constexpr std::size_t place_of_pc = 6;
    std::uint32_t exception = 0;
    asm volatile("mrs %0, ipsr" : "=r"(exception));
    log.send_waiting(); // makes room
    write_text(log, "\nFAULT ");
    write_decimal(log, exception);
    write_text(log, " at ");
    write_hex(log, frame[place_of_pc]);
    log.write('\n');
    log.send_waiting();
    while (true) {
        pico::led::toggle();
        for (std::uint32_t turns = 4'000'000; turns > 0; --turns)
            asm volatile("");
    }
}

/// Any exception that nobody handles.
[[gnu::naked]] void fault_handler()
{
    asm volatile("mrs r0, msp\n"
                 "ldr r1, =report_fault\n"
                 "bx r1\n"
                 ".ltorg");
}
}

namespace {

using Handler = void (*)();

struct VectorTable {
    std::uint32_t* stack;
    std::array<Handler, 15 + 26> handlers; ///< 15 of the processor, 26 of the chip
};

constexpr std::size_t of_chip(kfast::pico::Interrupt interrupt)
{
    return 15 + static_cast<std::size_t>(interrupt);
}

constexpr std::array<Handler, 41> handlers = [] {
    using kfast::pico::Interrupt;
    std::array<Handler, 41> table{};
    table.fill(fault_handler);
    table[0] = reset_handler;
    table[of_chip(Interrupt::timer_irq_0)] = timer_0_handler;
    table[of_chip(Interrupt::usbctrl_irq)] = usb_handler;
    table[of_chip(Interrupt::io_irq_bank0)] = io_bank0_handler;
    table[of_chip(Interrupt::uart0_irq)] = uart_handler;
    table[of_chip(Interrupt::uart1_irq)] = uart_handler;
    table[of_chip(Interrupt::i2c0_irq)] = i2c0_handler;
    table[of_chip(Interrupt::i2c1_irq)] = i2c1_handler;
    return table;
}();

[[gnu::section(".vectors"), gnu::used]] constinit const VectorTable vectors{stack_top, handlers};

}

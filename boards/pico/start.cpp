// The vectors and what runs before main(). Until the code is in RAM nothing may be called, so this is
// compiled with -fno-tree-loop-distribute-patterns: loops stay loops.

#include "boards/pico/app/log.hpp"
#include "boards/pico/chip/interrupts.hpp"
#include "boards/pico/chip/led.hpp"
#include "firmware/chip/cortex_m_start.hpp"

int main();

extern "C" {

// From the linker script.
extern std::uint32_t code_load[];
extern std::uint32_t code_begin[];
extern std::uint32_t code_end[];

void fault_handler();

void timer_0_handler();
void usb_handler();
void uart_handler();
// Not every image has it.
[[gnu::weak]] void make_safe();
[[gnu::weak, gnu::alias("fault_handler")]] void io_bank0_handler() noexcept;
[[gnu::weak, gnu::alias("fault_handler")]] void i2c0_handler() noexcept;
[[gnu::weak, gnu::alias("fault_handler")]] void i2c1_handler() noexcept;

[[noreturn, gnu::section(".start")]] void reset_handler()
{
    const std::uint32_t* from = code_load;
    for (std::uint32_t* to = code_begin; to != code_end;)
        *to++ = *from++;
    kfast::cortex_m::clear_bss();
    asm volatile("" ::: "memory");
    main();
    while (true)
        asm volatile("wfe");
}

/// Prints the exception (3 is a hard fault, 16 and more are interrupts of the chip) and its address, and
/// blinks quickly until the watchdog restarts everything. `frame` is what the processor saved.
[[noreturn, gnu::used]] void report_fault(const std::uint32_t* frame)
{
    using namespace kfast;
    using pico::log;
    if (make_safe != nullptr)
        make_safe();
    constexpr std::size_t place_of_pc = 6;
    const std::uint32_t exception = cortex_m::active_exception();
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

/// Any exception without a handler.
[[gnu::naked]] void fault_handler()
{
    asm volatile("mrs r0, msp\n"
                 "ldr r1, =report_fault\n"
                 "bx r1\n"
                 ".ltorg");
}
}

namespace {

using kfast::pico::Interrupt;

constexpr std::size_t chip_interrupts = 26;
using Vectors = kfast::cortex_m::VectorTable<chip_interrupts>;

constexpr std::size_t exception(Interrupt interrupt)
{
    return kfast::cortex_m::interrupt(static_cast<std::size_t>(interrupt));
}

[[gnu::section(".vectors"), gnu::used]] constinit const Vectors vectors =
    Vectors{reset_handler, fault_handler}
        .with(exception(Interrupt::timer_irq_0), timer_0_handler)
        .with(exception(Interrupt::usbctrl_irq), usb_handler)
        .with(exception(Interrupt::io_irq_bank0), io_bank0_handler)
        .with(exception(Interrupt::uart0_irq), uart_handler)
        .with(exception(Interrupt::uart1_irq), uart_handler)
        .with(exception(Interrupt::i2c0_irq), i2c0_handler)
        .with(exception(Interrupt::i2c1_irq), i2c1_handler);

}

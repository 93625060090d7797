#include "boards/lm3s6965evb/uart.hpp"
#include "firmware/chip/cortex_m_start.hpp"
#include "firmware/serial/console.hpp"

int main();

extern "C" {

void ssi0_handler();
void systick_handler();

[[noreturn]] void stop()
{
    while (true)
        asm volatile("wfi");
}

[[noreturn]] void reset_handler()
{
    using namespace kfast::cortex_m;
    switch_fpu_on();
    copy_data();
    clear_bss();
    main();
    stop();
}

/// Any exception without a handler: prints its number (3 is a hard fault) and stops.
[[noreturn]] void fault_handler()
{
    using namespace kfast;
    write_text(lm3s6965evb::uart, "FAULT ");
    write_decimal(lm3s6965evb::uart, cortex_m::active_exception());
    lm3s6965evb::uart.write('\n');
    stop();
}
}

namespace {

using namespace kfast::cortex_m;

constexpr std::size_t chip_interrupts = 44;
using Vectors = VectorTable<chip_interrupts>;

[[gnu::section(".vectors"), gnu::used]] constinit const Vectors vectors =
    Vectors{reset_handler, fault_handler}.with(systick, systick_handler).with(interrupt(7), ssi0_handler);

}

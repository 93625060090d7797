#include "firmware/chip/cortex_m_start.hpp"

int main();

extern "C" {

/// Also called for an exception without a handler.
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
}

namespace {

using namespace kfast::cortex_m;

constexpr std::size_t chip_interrupts = 32; // as many as the chip has
using Vectors = VectorTable<chip_interrupts>;

/// Add yours: .with(systick, systick_handler), .with(interrupt(7), uart_handler).
[[gnu::section(".vectors"), gnu::used]] constinit const Vectors vectors = Vectors{reset_handler, stop};

}

#include "firmware/chip/cortex_m_start.hpp"
#include "tests/bench/image/harness/painted_stack.hpp"
#include "tests/bench/image/harness/semihosting.hpp"

int main();

extern "C" {

void systick_handler();

[[noreturn]] void reset_handler()
{
    using namespace kfast;
    cortex_m::switch_fpu_on();
    cortex_m::copy_data();
    cortex_m::clear_bss();
    bench::paint_stack();
    bench::semihosting::exit(main());
}

[[noreturn]] void fault_handler()
{
    kfast::bench::semihosting::write("fault\n");
    kfast::bench::semihosting::exit(99);
}
}

namespace {

using namespace kfast::cortex_m;

[[gnu::section(".vectors"), gnu::used]] constinit const VectorTable<0> vectors =
    VectorTable<0>{reset_handler, fault_handler}.with(systick, systick_handler);

}

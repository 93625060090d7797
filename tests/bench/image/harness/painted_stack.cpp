#include "tests/bench/image/harness/painted_stack.hpp"

extern "C" {
// From the linker script.
extern std::uint32_t stack_bottom[];
extern std::uint32_t stack_top[];
}

namespace kfast::bench {
namespace {

constexpr std::uint32_t paint = 0xC01'0C01;

}

void paint_stack()
{
    const std::uint32_t* in_use = nullptr;
    asm volatile("mov %0, sp" : "=r"(in_use));
    for (volatile std::uint32_t* word = stack_bottom; word < in_use; word = word + 1)
        *word = paint;
}

std::uint32_t used_stack()
{
    const volatile std::uint32_t* deepest = stack_bottom;
    while (deepest < stack_top && *deepest == paint)
        ++deepest;
    return static_cast<std::uint32_t>(stack_top - deepest) * sizeof paint;
}

}

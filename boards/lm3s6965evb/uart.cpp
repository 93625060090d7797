#include "boards/lm3s6965evb/uart.hpp"

#include "boards/lm3s6965evb/clocks.hpp"
#include "boards/lm3s6965evb/registers.hpp"

namespace kfast::lm3s6965evb {
namespace {

constexpr std::uint32_t divisor = Pl011::divisor(system_hz, 115'200);
static_assert(divisor == 27 * 64 + 8);

}

void start_uart()
{
    gpio_a_afsel.set(0x03);
    gpio_a_den.set(0x03);
    uart.begin(divisor);
}

}

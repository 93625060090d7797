#include "boards/pico/tearing_line.hpp"

#include "boards/pico/interrupts.hpp"
#include "boards/pico/pins.hpp"
#include "boards/pico/register.hpp"

namespace kfast::pico {
namespace {

// Four bits for each pin, eight pins a register
constexpr Register edges_seen(Pin pin) { return Register{0x4001'40F0 + 4u * (pin / 8u)}; }
constexpr Register interrupt_enable(Pin pin) { return Register{0x4001'4100 + 4u * (pin / 8u)}; }
constexpr std::uint32_t rising_edge(Pin pin) { return 8u << 4 * (pin % 8); }

Pin line = 0;
volatile std::uint32_t pictures_shown = 0;

}

TearingLine::TearingLine(Pin pin)
{
    if (pin == no_pin)
        return;
    line = pin;
    const InputPin input{pin};
    edges_seen(pin).write(rising_edge(pin));
    interrupt_enable(pin).write(rising_edge(pin));
    enable(Interrupt::io_bank0);
}

std::uint32_t TearingLine::pictures() const { return pictures_shown; }

extern "C" void isr_io_bank0()
{
    edges_seen(line).write(rising_edge(line));
    pictures_shown = pictures_shown + 1;
}

}

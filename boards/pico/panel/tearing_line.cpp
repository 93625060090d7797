#include "boards/pico/panel/tearing_line.hpp"

#include "boards/pico/chip/interrupts.hpp"
#include "boards/pico/chip/pin_edges.hpp"
#include "boards/pico/chip/pins.hpp"

namespace kfast::pico {
namespace {

Pin line = 0;
volatile std::uint32_t pictures_shown = 0;

}

TearingLine::TearingLine(Pin pin)
{
    if (pin == no_pin)
        return;
    line = pin;
    connect_input(pin);
    pin_edges::intr(pin).write(pin_edges::edge_high(pin));
    pin_edges::proc0_inte(pin).write(pin_edges::edge_high(pin));
    enable(Interrupt::io_irq_bank0);
}

std::uint32_t TearingLine::pictures() const { return pictures_shown; }

extern "C" void io_bank0_handler()
{
    pin_edges::intr(line).write(pin_edges::edge_high(line));
    pictures_shown = pictures_shown + 1;
}

}

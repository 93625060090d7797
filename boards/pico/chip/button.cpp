#include "boards/pico/chip/button.hpp"

#include "boards/pico/chip/pin_edges.hpp"
#include "boards/pico/chip/pins.hpp"

namespace kfast::pico::button {

void begin(Pin pin)
{
    connect_input(pin);
    pin_edges::intr(pin).write(pin_edges::edge_low(pin));
}

bool pressed(Pin pin)
{
    const bool has_closed = (pin_edges::intr(pin).read() & pin_edges::edge_low(pin)) != 0;
    pin_edges::intr(pin).write(pin_edges::edge_low(pin));
    return has_closed || !is_high(pin);
}

}

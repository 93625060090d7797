#include "boards/pico/chip/button.hpp"

#include "boards/pico/chip/pin_edges.hpp"
#include "boards/pico/chip/pins.hpp"

namespace kfast::pico::button {

void begin(Pin pin)
{
    connect_input(pin);
    pin_edges::seen(pin).write(pin_edges::fallen(pin));
}

bool pressed(Pin pin)
{
    const bool has_closed = (pin_edges::seen(pin).read() & pin_edges::fallen(pin)) != 0;
    pin_edges::seen(pin).write(pin_edges::fallen(pin));
    return has_closed || !is_high(pin);
}

}

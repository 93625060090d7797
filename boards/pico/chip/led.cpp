#include "boards/pico/chip/led.hpp"

#include "boards/pico/chip/pins.hpp"
#include "boards/pico/chip/register.hpp"

#include <cstdint>

namespace kfast::pico::led {
namespace {

constexpr Pin pin = 25;
constexpr Register sio_gpio_out_xor{0xD000'001C};

}

void begin() { OutputPin{pin, Pad::output}.low(); }

void toggle() { sio_gpio_out_xor.write(1U << pin); }

}

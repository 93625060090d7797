#include "boards/pico/chip/led.hpp"

#include "boards/pico/chip/pins.hpp"
#include "boards/pico/chip/register.hpp"

#include <cstdint>

namespace kfast::pico::led {
namespace {

constexpr Pin pin = 25;
constexpr Register turn_outputs{0xD000'001C};

}

void begin() { OutputPin{pin, Pad::output}.low(); }

void toggle() { turn_outputs.write(1U << pin); }

}

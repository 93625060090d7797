#include "boards/pico/panel/dimmer.hpp"

#include "boards/pico/chip/pins.hpp"
#include "boards/pico/chip/register.hpp"
#include "boards/pico/chip/resets.hpp"
#include "firmware/settings/rp2040_pins.hpp"

namespace kfast::pico {
namespace {

// A slice of the PWM
struct Slice {
    std::uint32_t base;

    constexpr Register csr() const { return Register{base + 0x00}; }
    constexpr Register div() const { return Register{base + 0x04}; }
    constexpr Register cc() const { return Register{base + 0x0C}; }
    constexpr Register top() const { return Register{base + 0x10}; }
};

constexpr Slice slice_of(Pin pin)
{
    return {0x4005'0000u + 0x14u * static_cast<std::uint32_t>(rp2040::pulse_output(pin).slice)};
}

constexpr std::uint32_t steps = 255;  // a level of 255 lasts for all of them
constexpr std::uint32_t divisor = 16; // 125 MHz / 16 / 255
constexpr std::uint32_t csr_en = 1 << 0;
constexpr int div_int_lsb = 4;

}

Dimmer::Dimmer(Pin pin) : pin_{pin}
{
    if (pin == no_pin)
        return;
    resets::restart(resets::pwm);
    const Slice slice = slice_of(pin);
    slice.div().write(divisor << div_int_lsb);
    slice.top().write(steps - 1);
    slice.cc().write(0);
    slice.csr().write(csr_en);
    connect(pin, PinFunction::pwm, Pad::output);
}

void Dimmer::set(std::uint8_t brightness) const
{
    if (pin_ != no_pin)
        slice_of(pin_).cc().write(std::uint32_t{brightness} << 16 * rp2040::pulse_output(pin_).channel);
}

}

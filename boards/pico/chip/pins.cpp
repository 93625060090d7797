#include "boards/pico/chip/pins.hpp"

#include "boards/pico/chip/register.hpp"
#include "boards/pico/chip/resets.hpp"

namespace kfast::pico {
namespace {

// PADS_BANK0
constexpr Register pads_bank0_gpio(Pin pin) { return Register{0x4001'C004 + 4u * pin}; }

constexpr std::uint32_t pad_slewfast = 1 << 0;
constexpr std::uint32_t pad_schmitt = 1 << 1;
constexpr std::uint32_t pad_pue = 1 << 3; // pull-up
constexpr std::uint32_t pad_drive_4ma = 1 << 4;
constexpr std::uint32_t pad_drive_8ma = 2 << 4;
constexpr std::uint32_t pad_ie = 1 << 6; // input
constexpr std::uint32_t pad_od = 1 << 7; // no output

// SIO, the processor's own unit: no set and clear aliases.
constexpr Register sio_gpio_in{0xD000'0004};
constexpr Register sio_gpio_out_set{0xD000'0014};
constexpr Register sio_gpio_out_clr{0xD000'0018};
constexpr Register sio_gpio_oe_set{0xD000'0024};
constexpr Register sio_gpio_oe_clr{0xD000'0028};

constexpr std::uint32_t pad_bits(Pad pad)
{
    switch (pad) {
    case Pad::output:
        return pad_ie | pad_schmitt | pad_drive_4ma;
    case Pad::fast_output:
        return pad_ie | pad_schmitt | pad_drive_8ma | pad_slewfast;
    case Pad::pulled_up:
        return pad_ie | pad_schmitt | pad_drive_4ma | pad_pue;
    case Pad::converter_input:
        return pad_od;
    }
    return 0;
}

constexpr std::uint32_t bit_of(Pin pin) { return pin == no_pin ? 0 : 1u << pin; }

}

void connect(Pin pin, PinFunction function, Pad pad)
{
    if (pin == no_pin)
        return;
    resets::release(resets::io_bank0 | resets::pads_bank0);
    pads_bank0_gpio(pin).write(pad_bits(pad));
    gpio_ctrl(pin).write(static_cast<std::uint32_t>(function));
}

OutputPin::OutputPin(Pin pin, Pad pad) : bit_{bit_of(pin)}
{
    sio_gpio_out_set.write(bit_);
    sio_gpio_oe_set.write(bit_);
    connect(pin, PinFunction::sio, pad);
}

void OutputPin::high() const { sio_gpio_out_set.write(bit_); }
void OutputPin::low() const { sio_gpio_out_clr.write(bit_); }

OpenDrainPin::OpenDrainPin(Pin pin) : bit_{bit_of(pin)}
{
    let_go();
    sio_gpio_out_clr.write(bit_);
    connect(pin, PinFunction::sio, Pad::pulled_up);
}

void OpenDrainPin::pull_low() const { sio_gpio_oe_set.write(bit_); }
void OpenDrainPin::let_go() const { sio_gpio_oe_clr.write(bit_); }

void connect_input(Pin pin) { connect(pin, PinFunction::sio, Pad::pulled_up); }

bool is_high(Pin pin) { return (sio_gpio_in.read() & bit_of(pin)) != 0; }

}

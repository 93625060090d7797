#include "boards/pico/chip/pins.hpp"

#include "boards/pico/chip/register.hpp"
#include "boards/pico/chip/resets.hpp"

namespace kfast::pico {
namespace {

constexpr Register pad_control(Pin pin) { return Register{0x4001'C004 + 4u * pin}; }

constexpr std::uint32_t fast_edges = 1 << 0;
constexpr std::uint32_t schmitt_trigger = 1 << 1;
constexpr std::uint32_t pull_up = 1 << 3;
constexpr std::uint32_t drive_4_ma = 1 << 4;
constexpr std::uint32_t drive_8_ma = 2 << 4;
constexpr std::uint32_t input_enable = 1 << 6;
constexpr std::uint32_t output_disable = 1 << 7;

// The processor's own unit: no set and clear aliases.
constexpr Register level_in{0xD000'0004};
constexpr Register level_set{0xD000'0014};
constexpr Register level_clear{0xD000'0018};
constexpr Register drive_set{0xD000'0024};
constexpr Register drive_clear{0xD000'0028};

constexpr std::uint32_t pad_bits(Pad pad)
{
    switch (pad) {
    case Pad::output:
        return input_enable | schmitt_trigger | drive_4_ma;
    case Pad::fast_output:
        return input_enable | schmitt_trigger | drive_8_ma | fast_edges;
    case Pad::pulled_up:
        return input_enable | schmitt_trigger | drive_4_ma | pull_up;
    case Pad::converter_input:
        return output_disable;
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
    pad_control(pin).write(pad_bits(pad));
    pin_control(pin).write(static_cast<std::uint32_t>(function));
}

OutputPin::OutputPin(Pin pin, Pad pad) : bit_{bit_of(pin)}
{
    level_set.write(bit_);
    drive_set.write(bit_);
    connect(pin, PinFunction::processor, pad);
}

void OutputPin::high() const { level_set.write(bit_); }
void OutputPin::low() const { level_clear.write(bit_); }

OpenDrainPin::OpenDrainPin(Pin pin) : bit_{bit_of(pin)}
{
    let_go();
    level_clear.write(bit_);
    connect(pin, PinFunction::processor, Pad::pulled_up);
}

void OpenDrainPin::pull_low() const { drive_set.write(bit_); }
void OpenDrainPin::let_go() const { drive_clear.write(bit_); }

void connect_input(Pin pin) { connect(pin, PinFunction::processor, Pad::pulled_up); }

bool is_high(Pin pin) { return (level_in.read() & bit_of(pin)) != 0; }

}

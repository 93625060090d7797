#include "boards/pico/chip/converter.hpp"

#include "boards/pico/chip/pins.hpp"
#include "boards/pico/chip/register.hpp"
#include "boards/pico/chip/resets.hpp"
#include "firmware/settings/rp2040_pins.hpp"

#include <cstdint>

namespace kfast::pico::converter {
namespace {

constexpr Register control{0x4004'C000};
constexpr Register result{0x4004'C004};
constexpr std::uint32_t unit_enable = 1 << 0;
constexpr std::uint32_t convert_once = 1 << 2;
constexpr std::uint32_t ready = 1 << 8;
constexpr int input_at = 12;

constexpr int conversions = 4;

void wait_until_ready()
{
    while ((control.read() & ready) == 0) {
    }
}

int convert(std::uint32_t input)
{
    control.write(unit_enable | input << input_at | convert_once);
    wait_until_ready();
    return static_cast<int>(result.read());
}

}

void begin(Pin pin)
{
    connect(pin, PinFunction::none, Pad::converter_input);
    resets::release(resets::adc);
    control.write(unit_enable);
    wait_until_ready();
}

int read(Pin pin)
{
    const auto input = static_cast<std::uint32_t>(*rp2040::converter_input(pin));
    int sum = 0;
    for (int i = 0; i < conversions; ++i)
        sum += convert(input);
    return sum / conversions;
}

}

#include "boards/pico/chip/converter.hpp"

#include "boards/pico/chip/pins.hpp"
#include "boards/pico/chip/register.hpp"
#include "boards/pico/chip/resets.hpp"
#include "firmware/settings/rp2040_pins.hpp"

#include <cstdint>

namespace kfast::pico::converter {
namespace {

// ADC
constexpr Register cs{0x4004'C000};
constexpr Register result{0x4004'C004};
constexpr std::uint32_t cs_en = 1 << 0;
constexpr std::uint32_t cs_start_once = 1 << 2;
constexpr std::uint32_t cs_ready = 1 << 8;
constexpr int cs_ainsel_lsb = 12;

constexpr int conversions = 4;

void wait_until_ready()
{
    while ((cs.read() & cs_ready) == 0) {
    }
}

int convert(std::uint32_t input)
{
    cs.write(cs_en | input << cs_ainsel_lsb | cs_start_once);
    wait_until_ready();
    return static_cast<int>(result.read());
}

}

void begin(Pin pin)
{
    connect(pin, PinFunction::null, Pad::converter_input);
    resets::release(resets::adc);
    cs.write(cs_en);
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

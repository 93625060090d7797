#include "host/config/pico_edge.hpp"

#include "firmware/settings/rp2040_pins.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>

namespace kfast::config {
namespace {

struct NamedPin {
    int pin;
    std::string_view name;
};

constexpr std::array other_pins{
    NamedPin{30, "RUN"},    NamedPin{33, "AGND"}, NamedPin{35, "ADC_VREF"}, NamedPin{36, "3V3"},
    NamedPin{37, "3V3_EN"}, NamedPin{39, "VSYS"}, NamedPin{40, "VBUS"},
};

bool is_left(int pin) { return pin <= pins_of_side; }

}

std::string edge_name(int pin)
{
    const auto other = std::ranges::find(other_pins, pin, &NamedPin::pin);
    if (other != other_pins.end())
        return std::string{other->name};
    const auto gpio = std::ranges::find(rp2040::pico_pins, pin);
    return gpio == rp2040::pico_pins.end()
               ? "GND"
               : std::string{rp2040::pin_names[static_cast<std::size_t>(gpio - rp2040::pico_pins.begin())]};
}

int edge_pin(Pin gpio) { return rp2040::pico_pins[gpio]; }

std::string_view edge_side(int pin) { return is_left(pin) ? "left" : "right"; }

int nearest_ground(int pin)
{
    return *std::ranges::min_element(rp2040::pico_ground_pins, {}, [pin](int ground) {
        return is_left(ground) == is_left(pin) ? std::abs(ground - pin) : std::numeric_limits<int>::max();
    });
}

}

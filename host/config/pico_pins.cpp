#include "host/config/pico_pins.hpp"

#include "firmware/settings/rp2040_pins.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <utility>
#include <vector>

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

namespace {

constexpr int shortest_run = 3; ///< that is written as "… to …"

static_assert(lie_on_board({last_pin_of_eight, 8}) && !lie_on_board({last_pin_of_eight + 1, 8}));

std::string run_text(int first, int end)
{
    std::string text = pin_name(first);
    if (end - first >= shortest_run)
        return text + " to " + pin_name(end - 1);
    for (int pin = first + 1; pin < end; ++pin)
        text += ", " + pin_name(pin);
    return text;
}

/// All pins of the edge for which `holds` is true.
template <class Condition>
std::string listed(Condition holds)
{
    const auto is_listed = [&](int pin) {
        return pin < rp2040::pin_count && rp2040::is_on_pico_edge(static_cast<Pin>(pin)) &&
               holds(static_cast<Pin>(pin));
    };
    std::string text;
    for (int first = 0; first < rp2040::pin_count; ++first) {
        int end = first;
        while (is_listed(end))
            ++end;
        if (end > first)
            text += (text.empty() ? "" : ", ") + run_text(first, end);
        first = std::max(first, end);
    }
    return text;
}

bool is_used(const BoardSettings& settings, int pin)
{
    for (std::size_t i = 0; i < PinUser::count; ++i) {
        const PinRow row = pins_of(settings, PinUser::number(i));
        if (pin >= row.first && pin < row.end())
            return true;
    }
    return false;
}

}

std::string pin_name(int pin) { return "GP" + std::to_string(pin); }

std::string pins_on_edge()
{
    return listed([](Pin) { return true; });
}

std::string free_pins(const BoardSettings& settings)
{
    return listed([&](Pin pin) { return !is_used(settings, pin); });
}

std::string pins_that_carry(PinRole role, BusKind bus, std::optional<std::string_view> unit)
{
    return listed([&](Pin pin) {
        const std::string_view function = rp2040::function_name(role, bus, pin);
        return !function.empty() && (!unit || function.starts_with(*unit));
    });
}

}

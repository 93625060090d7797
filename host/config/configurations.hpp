#pragma once

#include "firmware/settings/board_settings.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace kfast::config {

/// Settings that are part of this program: a file of boards/pico/configurations.
struct Configuration {
    std::string_view name;
    std::string_view text;
};

std::span<const Configuration> configurations();

/// The ready configuration whose settings an image for this bus takes when flash holds none: what
/// boards/pico/app/default_settings.hpp has.
inline std::string default_configuration(BusKind bus)
{
    constexpr std::array names{"pico-st7789", "pico-ssd1306-i2c", "pico-ili9341-parallel", "pico-xy-scope"};
    static_assert(names.size() == bus_names.size());
    return names[static_cast<std::size_t>(bus)];
}

}

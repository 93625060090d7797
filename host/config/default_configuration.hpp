#pragma once

#include "firmware/settings/board_settings.hpp"

#include <array>
#include <cstddef>
#include <string>

namespace kfast::config {

/// The ready configuration whose settings an image for this bus takes when flash holds none: what
/// boards/pico/app/default_settings.hpp has.
inline std::string default_configuration(BusKind bus)
{
    constexpr std::array names{"pico-st7789", "pico-ssd1306-i2c", "pico-ili9341-parallel", "pico-xy-scope"};
    static_assert(names.size() == bus_names.size());
    return names[static_cast<std::size_t>(bus)];
}

}

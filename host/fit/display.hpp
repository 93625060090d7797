#pragma once

#include "core/pixel_format.hpp"
#include "core/size.hpp"

#include <cstddef>
#include <span>
#include <string_view>

namespace kfast::fit {

/// A panel, as far as it decides what is drawn and sent.
struct Display {
    std::string_view name = "";
    Size size;
    PixelFormat format = PixelFormat::rgb565;
    Size granularity{1, 1};        ///< places and sizes of what is sent are multiples of this
    std::size_t window_bytes = 11; ///< commands that open a window
    double rated_spi = 0;          ///< Hz that the maker allows for writing; 0: not known
};

/// Controllers that can be named.
std::span<const Display> known_displays();

}

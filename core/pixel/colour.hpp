#pragma once

#include <cstdint>

namespace kfast {

/// 8 bits per channel, as scenes store colours; an opacity of 255 is opaque.
struct Colour {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
    std::uint8_t opacity = 255;
    friend constexpr bool operator==(Colour, Colour) = default;
};

}

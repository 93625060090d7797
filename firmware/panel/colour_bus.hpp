#pragma once

#include "core/pixel/pixel_format.hpp"
#include "firmware/panel/bus.hpp"

#include <cstddef>
#include <span>

namespace kfast {

/// How 16-bit colours are stored in memory for this bus: controllers expect the high byte first.
template <DisplayBus Bus>
inline constexpr PixelFormat colour_format = WordBus<Bus> ? PixelFormat::rgb565 : PixelFormat::rgb565_be;

/// Starts to send pixels that are in colour_format<Bus>.
template <DisplayBus Bus>
void start_colours(Bus& bus, std::span<const std::byte> pixels)
{
    if constexpr (WordBus<Bus>)
        bus.start_words(pixels);
    else
        bus.start_data(pixels);
}

}

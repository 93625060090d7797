#pragma once

#include "core/math/point.hpp"
#include "core/pixel/pixel_format.hpp"
#include "firmware/chip/microseconds.hpp"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

// Compound requirements would be torn apart.
// clang-format off

/// A display controller, ready to show rectangles of pixels.
template <class P>
concept Panel = requires(P& panel, void (&pause)(Microseconds), Rect area, std::span<const std::byte> pixels) {
    /// The format of pixels in memory and on the bus.
    { P::format } -> std::same_as<const PixelFormat&>;
    /// Positions and sizes of areas must be multiples of this, as the panel's size is: for panels whose bytes
    /// hold several pixels. No larger than raster::max_granularity.
    { P::granularity } -> std::same_as<const Size&>;
    /// What an area costs on the bus besides its pixels, in bytes.
    { P::window_bytes } -> std::same_as<const int&>;
    { panel.size() } -> std::same_as<Size>;
    /// Sends the start-up sequence. `pause(Microseconds)` lets time pass. A LightedPanel stays dark.
    { panel.begin(pause) } -> std::same_as<void>;
    /// Starts to show `pixels`, packed row by row, in `area` and returns; the pixels must stay as they are
    /// until busy() is false. Not while busy().
    { panel.start(area, pixels) } -> std::same_as<void>;
    { panel.busy() } -> std::same_as<bool>;
};

/// A panel that shows nothing after begin() or wake() until light() is called: its memory holds noise then.
template <class P>
concept LightedPanel = Panel<P> && requires(P& panel) {
    /// Shows what was sent from now on. Not while busy().
    { panel.light() } -> std::same_as<void>;
};

/// A panel whose light and power can be controlled.
template <class P>
concept PoweredPanel = Panel<P> && requires(P& panel, void (&pause)(Microseconds), std::uint8_t brightness) {
    /// Of the light, or of the pixels that shine, as far as the controller controls it. Not while busy().
    { panel.set_brightness(brightness) } -> std::same_as<void>;
    /// Lowest power: nothing is shown and start() is not allowed until wake(), after which the whole picture
    /// must be sent again; a LightedPanel stays dark. Not while busy().
    { panel.sleep(pause) } -> std::same_as<void>;
    { panel.wake(pause) } -> std::same_as<void>;
};

// clang-format on

}

#pragma once

#include "core/math/point.hpp"
#include "core/pixel/pixel_format.hpp"

#include <cstddef>
#include <span>

namespace kfast::vexpress_a9 {

/// Chosen by the build: KFAST_GLASS_WIDTH and KFAST_GLASS_HEIGHT.
inline constexpr Size glass{.width = KFAST_GLASS_WIDTH, .height = KFAST_GLASS_HEIGHT};

/// A picture in RAM that the display controller PL111 shows all the time. A Panel, never busy.
class Framebuffer {
public:
    static constexpr PixelFormat format = PixelFormat::rgb565;
    static constexpr Size granularity{.width = 1, .height = 1};
    static constexpr int window_bytes = 0;

    Size size() const { return glass; }

    template <class Pause>
    void begin(Pause&&)
    {
        switch_on();
    }

    void start(Rect area, std::span<const std::byte> pixels);
    bool busy() const { return false; }

private:
    static void switch_on();
};

}

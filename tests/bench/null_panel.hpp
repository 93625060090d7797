#pragma once

#include "core/bytes/crc32.hpp"
#include "core/math/point.hpp"
#include "core/pixel/pixel_format.hpp"
#include "tests/bench/phase.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace kfast::bench {

/// What has gone over the bus.
struct Traffic {
    std::uint32_t windows = 0;
    std::uint32_t bytes = 0; ///< pixels, and the commands that open the windows
    Crc32 pixels;            ///< if the meter checks them
};

/// A colour LCD that takes every window at once, and counts. It is told its size later than it is made,
/// because that comes from the scene.
template <class Meter>
class NullPanel {
public:
    static constexpr PixelFormat format = PixelFormat::rgb565;
    static constexpr Size granularity{.width = 1, .height = 1};
    /// CASET and RASET with four bytes each, RAMWR.
    static constexpr int window_bytes = 5 + 5 + 1;

    explicit NullPanel(Meter& meter) : meter_{meter} {}

    void set_size(Size size) { size_ = size; }
    Size size() const { return size_; }

    template <class Pause>
    void begin(Pause&&)
    {
    }

    void start(Rect, std::span<const std::byte> pixels)
    {
        meter_.enter(Phase::elsewhere);
        ++traffic_.windows;
        traffic_.bytes += window_bytes + static_cast<std::uint32_t>(pixels.size());
        if constexpr (Meter::checks_pixels)
            traffic_.pixels.add(pixels);
        meter_.enter(Phase::send);
    }

    bool busy() const { return false; }

    /// Since it was asked before.
    Traffic take_traffic() { return std::exchange(traffic_, {}); }

private:
    Meter& meter_;
    Size size_;
    Traffic traffic_;
};

}

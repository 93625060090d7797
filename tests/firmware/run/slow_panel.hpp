#pragma once

#include "core/math/point.hpp"
#include "core/pixel/pixel_format.hpp"
#include "firmware/chip/microseconds.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <doctest/doctest.h>
#include <span>
#include <vector>

namespace kfast::test {

/// A panel of 6 x 10 greys. It reads pixels only when they must have arrived, like DMA at its slowest.
class SlowPanel {
public:
    static constexpr PixelFormat format = PixelFormat::grey4;
    static constexpr Size granularity{.width = 2, .height = 2};
    static constexpr int window_bytes = 9;

    Size size() const { return {.width = 6, .height = 10}; }

    template <class Pause>
    void begin(Pause&& pause)
    {
        pause(Microseconds{120'000});
    }

    void start(Rect area, std::span<const std::byte> pixels)
    {
        REQUIRE(polls_left_ == 0);
        REQUIRE(pixels.size() == row_bytes(format, area.width) * static_cast<std::size_t>(area.height));
        areas.push_back(area);
        on_their_way_ = pixels;
        polls_left_ = 3;
    }

    bool busy()
    {
        if (polls_left_ == 0)
            return false;
        if (--polls_left_ == 0)
            arrive();
        return true;
    }

    bool is_sending() const { return polls_left_ != 0; }

    std::vector<Rect> areas;
    std::array<std::byte, 3 * 10> shown{};

private:
    void arrive()
    {
        const Rect area = areas.back();
        const std::size_t stride = row_bytes(format, area.width);
        for (int row = 0; row < area.height; ++row)
            std::copy_n(on_their_way_.begin() + static_cast<std::ptrdiff_t>(stride) * row, stride,
                        shown.begin() + 3 * (area.y + row) + area.x / 2);
    }

    std::span<const std::byte> on_their_way_;
    int polls_left_ = 0;
};

}

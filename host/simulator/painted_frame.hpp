#pragma once

#include "core/pixel/pixel_coding.hpp"
#include "host/picture/frame.hpp"

namespace kfast {

/// A picture whose pixel (x, y) is `pixel_at(x, y)`, coded in `format`.
template <PixelFormat format, class PixelAt>
Frame painted_frame(Size size, PixelAt pixel_at)
{
    const std::size_t stride = row_bytes(format, size.width);
    Frame frame{format, size, std::vector<std::byte>(stride * static_cast<std::size_t>(size.height))};
    for (int y = 0; y < size.height; ++y) {
        std::byte* row = frame.pixels.data() + stride * static_cast<std::size_t>(y);
        for (int x = 0; x < size.width; ++x)
            PixelCoding<format>::store(row, x, pixel_at(x, y));
    }
    return frame;
}

/// The pixel of a frame whose format is `format`.
template <PixelFormat format>
std::uint32_t pixel_of(const Frame& frame, int x, int y)
{
    const std::byte* row =
        frame.pixels.data() + row_bytes(format, frame.size.width) * static_cast<std::size_t>(y);
    return PixelCoding<format>::load(row, x);
}

}

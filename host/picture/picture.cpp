#include "host/picture/picture.hpp"

#include "core/pixel_row.hpp"

namespace kfast {
namespace {

constexpr std::uint8_t widened(std::uint32_t value, std::uint32_t max)
{
    return static_cast<std::uint8_t>(widen_channel(value, max));
}

constexpr Colour grey(std::uint32_t value, std::uint32_t max)
{
    const std::uint8_t level = widened(value, max);
    return {level, level, level};
}

Colour pixel(PixelFormat format, const std::byte* row, int x)
{
    const auto byte = [row](int index) { return std::to_integer<std::uint32_t>(row[index]); };
    switch (format) {
    case PixelFormat::rgb565: {
        const std::uint32_t word = byte(2 * x) | byte(2 * x + 1) << 8;
        return {widened(word >> 11, 31), widened((word >> 5) & 63, 63), widened(word & 31, 31)};
    }
    case PixelFormat::grey4:
        return grey((byte(x / 2) >> (x % 2 == 0 ? 4 : 0)) & 15, 15);
    case PixelFormat::mono1:
        return grey((byte(x / 8) >> (7 - x % 8)) & 1, 1);
    }
    return {};
}

}

Picture widen(const Frame& frame)
{
    Picture picture{frame.size, {}};
    picture.pixels.reserve(static_cast<std::size_t>(frame.size.width) *
                           static_cast<std::size_t>(frame.size.height));
    const std::size_t stride = row_bytes(frame.format, frame.size.width);
    for (int y = 0; y < frame.size.height; ++y) {
        const std::byte* row = frame.pixels.data() + stride * static_cast<std::size_t>(y);
        for (int x = 0; x < frame.size.width; ++x)
            picture.pixels.push_back(pixel(frame.format, row, x));
    }
    return picture;
}

}

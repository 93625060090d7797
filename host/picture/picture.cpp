#include "host/picture/picture.hpp"

#include "core/pixel/pixel_row.hpp"

namespace kfast {
namespace {

constexpr std::uint8_t widened(std::uint32_t value, std::uint32_t max)
{
    return static_cast<std::uint8_t>(widen_channel(value, max));
}

/// Of channels of that many bits, red in the highest.
constexpr Colour rgb(std::uint32_t pixel, int red, int green, int blue)
{
    const auto channel = [pixel](int shift, int bits) {
        const std::uint32_t max = (1U << bits) - 1;
        return widened(pixel >> shift & max, max);
    };
    return {channel(green + blue, red), channel(blue, green), channel(0, blue)};
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
    case PixelFormat::rgb565:
        return rgb(byte(2 * x) | byte(2 * x + 1) << 8, 5, 6, 5);
    case PixelFormat::rgb565_be:
        return rgb(byte(2 * x) << 8 | byte(2 * x + 1), 5, 6, 5);
    case PixelFormat::rgb444: {
        const std::uint32_t two_bytes = byte(3 * x / 2) << 8 | byte(3 * x / 2 + 1);
        return rgb(x % 2 == 0 ? two_bytes >> 4 : two_bytes, 4, 4, 4);
    }
    case PixelFormat::rgb666:
        return {widened(byte(3 * x) >> 2, 63), widened(byte(3 * x + 1) >> 2, 63),
                widened(byte(3 * x + 2) >> 2, 63)};
    case PixelFormat::grey4:
        return grey((byte(x / 2) >> (x % 2 == 0 ? 4 : 0)) & 15, 15);
    case PixelFormat::mono1:
    case PixelFormat::mono1_dithered:
        return grey((byte(x / 8) >> (7 - x % 8)) & 1, 1);
    }
    return {};
}

Picture without_format(const Frame& frame)
{
    Picture picture{frame.size, {}};
    picture.pixels.reserve(frame.pixels.size() / 3);
    for (std::size_t i = 0; i + 2 < frame.pixels.size(); i += 3)
        picture.pixels.push_back({std::to_integer<std::uint8_t>(frame.pixels[i]),
                                  std::to_integer<std::uint8_t>(frame.pixels[i + 1]),
                                  std::to_integer<std::uint8_t>(frame.pixels[i + 2])});
    return picture;
}

Picture in_format(const Frame& frame, PixelFormat format)
{
    Picture picture{frame.size, {}};
    picture.pixels.reserve(static_cast<std::size_t>(frame.size.width) *
                           static_cast<std::size_t>(frame.size.height));
    const std::size_t stride = row_bytes(format, frame.size.width);
    for (int y = 0; y < frame.size.height; ++y) {
        const std::byte* row = frame.pixels.data() + stride * static_cast<std::size_t>(y);
        for (int x = 0; x < frame.size.width; ++x)
            picture.pixels.push_back(pixel(format, row, x));
    }
    return picture;
}

}

Picture widen(const Frame& frame)
{
    return frame.format ? in_format(frame, *frame.format) : without_format(frame);
}

}

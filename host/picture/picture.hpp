#pragma once

#include "core/pixel/paint_style.hpp"
#include "core/pixel/pixel_format.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace kfast {

/// One full picture as a panel holds it: rows from the top, row_bytes(format, width) each. Without a format
/// it is that of no panel: 3 bytes a pixel, red, green and blue.
struct Frame {
    std::optional<PixelFormat> format = PixelFormat::rgb565;
    Size size;
    std::vector<std::byte> pixels;
};

/// CRC-32 of the pixels, the same on every target for the same scene, time, size and format.
std::uint32_t hash(const Frame& frame);

/// An image for the PC: 8 bits a channel, rows from the top without gaps.
struct Picture {
    Size size;
    std::vector<Colour> pixels;

    const Colour& at(int x, int y) const
    {
        const int index = y * size.width + x;
        return pixels[static_cast<std::size_t>(index)];
    }
};

/// Every channel v of at most max becomes (v * 255 + max / 2) div max.
Picture widen(const Frame& frame);

/// The maximum side of pictures in files.
inline constexpr std::int64_t longest_picture_side = 16384;
inline constexpr std::int64_t max_picture_pixels = std::int64_t{1} << 26;

/// The smallest area outside of which both pictures, of one size, are the same; none if they are equal.
std::optional<Rect> changed_part(const Picture& before, const Picture& after);

/// `area` must be within the picture.
Picture part(const Picture& picture, const Rect& area);

/// A picture of one colour. Throws Failure, in the name of `what` ("the sheet"), if that were more than
/// the maximum of pictures.
Picture plain_picture(std::int64_t width, std::int64_t height, Colour colour, const char* what);

/// Copies `picture` to `sheet`, with room for it, at `x` and `y`.
void put(const Picture& picture, Picture& sheet, int x, int y);

/// Each pixel as a square of `factor` pixels a side, at least 1. Throws Failure like plain_picture().
Picture scaled(const Picture& picture, int factor);

/// Red, green and blue of one pixel after the other.
inline std::vector<std::byte> channel_bytes(const Picture& picture)
{
    std::vector<std::byte> bytes;
    bytes.reserve(3 * picture.pixels.size());
    for (const Colour pixel : picture.pixels)
        bytes.insert(bytes.end(), {std::byte{pixel.red}, std::byte{pixel.green}, std::byte{pixel.blue}});
    return bytes;
}

}

#pragma once

#include "core/pixel/pixel_format.hpp"

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

}

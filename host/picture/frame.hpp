#pragma once

#include "core/pixel_format.hpp"

#include <cstdint>
#include <vector>

namespace kfast {

/// One full picture as a panel holds it: rows from the top, row_bytes(format, width) each.
struct Frame {
    PixelFormat format = PixelFormat::rgb565;
    Size size;
    std::vector<std::byte> pixels;
};

/// CRC-32 of the pixels, the same on every target for the same scene, time, size and format.
std::uint32_t hash(const Frame& frame);

}

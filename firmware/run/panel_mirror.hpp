#pragma once

#include "core/bytes/crc32.hpp"
#include "core/math/point.hpp"
#include "core/pixel/pixel_format.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// What a panel shows, assembled in RAM from what is sent to it. A board that is verified keeps it for the
/// hash of the picture, which must equal the one that `kfast hash` gives; a display controller may show it
/// from there.
template <PixelFormat format, int width, int height>
class PanelMirror {
public:
    /// `pixels` are packed row by row; `area` begins and ends on whole bytes.
    void take(Rect area, std::span<const std::byte> pixels)
    {
        const std::size_t bytes = row_bytes(format, area.width);
        std::byte* row =
            memory_.data() + static_cast<std::size_t>(area.y) * stride + row_bytes(format, area.x);
        for (; area.height > 0; --area.height, row += stride, pixels = pixels.subspan(bytes))
            std::ranges::copy(pixels.first(bytes), row);
    }

    /// All rows, one after another.
    std::span<const std::byte> bytes() const { return memory_; }

    /// CRC-32 of all rows.
    std::uint32_t hash() const
    {
        Crc32 crc;
        crc.add(memory_);
        return crc.value();
    }

private:
    static constexpr std::size_t stride = row_bytes(format, width);

    std::array<std::byte, stride * height> memory_{};
};

}

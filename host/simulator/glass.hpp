#pragma once

#include "core/math/point.hpp"
#include "core/pixel/pixel_coding.hpp"
#include "host/picture/picture.hpp"

#include <optional>
#include <string>

namespace kfast {

/// Where something is in a controller's memory, and on the glass.
struct GlassPlace {
    int column = 0;
    int row = 0;
    int x = 0;
    int y = 0;

    /// What is wrong with a pixel there.
    std::optional<std::string> mistake(Size glass) const
    {
        if (x >= 0 && x < glass.width && y >= 0 && y < glass.height)
            return std::nullopt;
        return "a pixel outside the glass: column " + std::to_string(column) + ", row " +
               std::to_string(row) + " of the memory";
    }
};

/// Which row of an OLED controller's memory each line of the glass shows: the lines are scanned one after
/// another, beginning with the row `start`, from the first line on or from the last one.
struct OledScan {
    int memory_rows = 0;
    int lines = 0; ///< how many are scanned
    int start = 0;
    bool from_last = false;

    /// What line `line` shows; nothing if it is not scanned.
    constexpr std::optional<int> row_of(int line) const
    {
        const int step = from_last ? lines - 1 - line : line;
        if (step < 0 || step >= lines)
            return std::nullopt;
        return (start + step) % memory_rows;
    }

    /// Which line shows a row, perhaps one beyond those that are scanned.
    constexpr int line_of(int row) const
    {
        const int step = (row - start + memory_rows) % memory_rows;
        return from_last ? lines - 1 - step : step;
    }
};

/// How OLED controllers show all pixels, as chosen by the commands A4h to A7h.
enum class OledShow { memory, all_lit, all_dark, inverse };

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

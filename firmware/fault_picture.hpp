#pragma once

#include "core/pixel_row.hpp"
#include "core/result.hpp"
#include "core/size.hpp"
#include "firmware/sending.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace kfast {

/// E and the number of an error in large blocks, white on black: what a panel of at least 9 x 7 pixels shows
/// when nothing can be played. A smaller one stays black.
class FaultPicture {
public:
    FaultPicture(Error error, Size panel)
        : number_{static_cast<std::uint8_t>(error)}, scale_{std::min(panel.width / (columns + 2),
                                                                     panel.height / (lines + 2))},
          left_{(panel.width - columns * scale_) / 2}, top_{(panel.height - lines * scale_) / 2}
    {
    }

    /// Paints row `row.y`, `width` pixels from column 0 on.
    template <PixelFormat format>
    void draw_row(PixelRow<format> row, int width) const
    {
        row.fill(0, width, row.ink(Colour{}));
        const int line = row.y < top_ || scale_ == 0 ? lines : (row.y - top_) / scale_;
        for (int column = 0; line < lines && column < columns; ++column)
            if (is_lit(column, line))
                row.fill(left_ + column * scale_, scale_, row.ink(Colour{255, 255, 255}));
    }

private:
    static constexpr int columns = 7; ///< two characters of three blocks and a gap
    static constexpr int lines = 5;

    /// Five lines of three blocks, the upper left one in the highest of 15 bits.
    static constexpr std::uint16_t letter_e = 0b111'100'111'100'111;
    static constexpr std::array<std::uint16_t, 10> digits{
        0b111'101'101'101'111, 0b010'110'010'010'111, 0b111'001'111'100'111, 0b111'001'111'001'111,
        0b101'101'111'001'001, 0b111'100'111'001'111, 0b111'100'111'101'111, 0b111'001'010'010'010,
        0b111'101'111'101'111, 0b111'101'111'001'111,
    };

    bool is_lit(int column, int line) const
    {
        if (column == 3)
            return false;
        const std::uint32_t blocks = column < 3 ? letter_e : digits[number_ % digits.size()];
        return (blocks >> (14 - 3 * line - column % 4) & 1) != 0;
    }

    std::uint8_t number_;
    int scale_;
    int left_;
    int top_;
};

/// Fills the panel with the number of the error.
template <Board B>
void show_fault(B& board, Error error)
{
    constexpr PixelFormat format = PanelOf<B>::format;
    const Size panel = board.panel().size();
    const std::size_t stride = row_bytes(format, panel.width);
    const FaultPicture picture{error, panel};
    std::array bands = board.bands();
    const int band_rows = rows_per_band(board.panel(), bands[0].size());
    for (int top = 0; top < panel.height; top += band_rows) {
        const int rows = std::min(band_rows, panel.height - top);
        const auto pixels = bands[0].first(static_cast<std::size_t>(rows) * stride);
        for (int y = 0; y < rows; ++y)
            picture.draw_row(
                PixelRow<format>{pixels.data() + static_cast<std::size_t>(y) * stride, 0, top + y},
                panel.width);
        send(board, {.x = 0, .y = top, .width = panel.width, .height = rows}, pixels);
        std::swap(bands[0], bands[1]);
    }
    wait_for(board.panel());
}

}

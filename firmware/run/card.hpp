#pragma once

#include "core/bytes/expects.hpp"
#include "core/math/point.hpp"
#include "core/pixel/pixel_row.hpp"
#include "firmware/run/sending.hpp"
#include "firmware/run/small_font.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

namespace kfast {

/// Lines of text below each other, each in the middle of the panel's width, white on black: what a board
/// shows when it has nothing to play.
class Card {
public:
    static constexpr std::size_t max_lines = 12;
    /// The distance of lines, in blocks: the letters and one below them.
    static constexpr int line_height = small_font::letter_height + 1;

    explicit Card(Size panel) : panel_{panel} {}

    Size panel() const { return panel_; }

    /// Adds a line, one of at most max_lines, whose first row is `top`. `text` must outlive the card and be
    /// within the panel; its letters are `scale` times as large as those of the font.
    void add(std::string_view text, int scale, int top)
    {
        expects(line_count_ < max_lines);
        const int left = (panel_.width - small_font::width(text) * scale) / 2;
        lines_[line_count_++] = {text, scale, left, top};
    }

    /// Paints row `row.y` of the panel, from column 0 on.
    template <PixelFormat format>
    void draw_row(PixelRow<format> row) const
    {
        row.fill(0, panel_.width, row.ink(Colour{}));
        for (const Line& line : std::span{lines_}.first(line_count_)) {
            const int below = row.y - line.top;
            if (below >= 0 && below < small_font::letter_height * line.scale)
                small_font::draw_line(row, line.text, line.left, line.scale, below / line.scale,
                                      Colour{255, 255, 255});
        }
    }

private:
    struct Line {
        std::string_view text;
        int scale;
        int left;
        int top;
    };

    Size panel_;
    std::array<Line, max_lines> lines_{};
    std::size_t line_count_ = 0;
};

/// Fills the panel with what `card.draw_row(PixelRow)` paints, and makes it visible.
template <PanelBoard B, class C>
void show_card(B& board, const C& card)
{
    constexpr PixelFormat format = PanelOf<B>::format;
    const Size panel = board.panel().size();
    const std::size_t stride = row_bytes(format, panel.width);
    std::array bands = board.bands();
    const int band_rows = rows_per_band(board.panel(), bands[0].size());
    for (int top = 0; top < panel.height; top += band_rows) {
        const int rows = std::min(band_rows, panel.height - top);
        const auto pixels = bands[0].first(static_cast<std::size_t>(rows) * stride);
        for (int y = 0; y < rows; ++y)
            card.draw_row(PixelRow<format>{pixels.data() + static_cast<std::size_t>(y) * stride, 0, top + y});
        send(board, {.x = 0, .y = top, .width = panel.width, .height = rows}, pixels);
        std::swap(bands[0], bands[1]);
    }
    wait_for(board.panel());
    light_panel(board);
}

}

#pragma once

#include "firmware/run/board.hpp"
#include "firmware/run/card.hpp"
#include "firmware/version.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace kfast {

/// What a board without a scene shows, so that one sees at once whether the display is set up correctly: a
/// frame of one pixel at the very border (offsets), which side is up, red, green and blue with their letters
/// (order of colours, inversion), board, panel, its size and the version. A panel that is too small for the
/// text shows the frame alone.
class TestCard {
public:
    TestCard(const BoardNames& names, Size panel) : size_text_{text_of(panel)}, card_{panel}
    {
        const std::array<std::string_view, 5> above{"^ top ^", names.board, names.panel, size_text(),
                                                    version_line};
        const std::string_view below = "no scene";
        scale_ = std::min(scale_for(above), scale_for(std::span{&below, 1}));
        if (scale_ == 0)
            return;
        const int height = Card::line_height * scale_;
        int top = (panel.height - lines * height) / 2;
        for (const std::string_view text : above) {
            card_.add(text, scale_, top);
            top += height;
        }
        bars_top_ = top;
        card_.add(below, scale_, top + bars_lines * height);
    }
    TestCard(const TestCard&) = delete;

    template <PixelFormat format>
    void draw_row(PixelRow<format> row) const
    {
        card_.draw_row(row);
        if (scale_ != 0 && row.y >= bars_top_ && row.y < bars_top_ + bars_height())
            draw_bars(row);
        draw_frame(row);
    }

private:
    static constexpr int lines = 8; ///< including those of the bars
    static constexpr int bars_lines = 2;

    struct Bar {
        std::string_view letter;
        Colour colour;
    };
    static constexpr std::array<Bar, 3> bars{{{"R", {255, 0, 0}}, {"G", {0, 255, 0}}, {"B", {0, 0, 255}}}};

    static constexpr std::array<char, 12> text_of(Size size)
    {
        std::array<char, 12> text{};
        char* at = write(size.width, text.data());
        *at++ = 'x';
        write(size.height, at);
        return text;
    }

    /// Writes a number in decimal; returns the end.
    static constexpr char* write(int number, char* at)
    {
        if (number >= 10)
            at = write(number / 10, at);
        *at = static_cast<char>('0' + number % 10);
        return at + 1;
    }

    std::string_view size_text() const
    {
        return {size_text_.data(),
                static_cast<std::size_t>(std::ranges::find(size_text_, '\0') - size_text_.begin())};
    }

    /// The largest letters with which all lines, as wide as the widest of `texts`, find room within the
    /// frame.
    int scale_for(std::span<const std::string_view> texts) const
    {
        const Size room{card_.panel().width - 4, card_.panel().height - 4};
        int scale = room.height / (lines * Card::line_height);
        for (const std::string_view text : texts)
            scale = std::min(scale, room.width / small_font::width(text));
        return std::max(0, scale);
    }

    int bars_height() const { return (bars_lines * Card::line_height - 1) * scale_; }

    template <PixelFormat format>
    void draw_bars(PixelRow<format> row) const
    {
        const int width = card_.panel().width / 4;
        const int left = (card_.panel().width - static_cast<int>(bars.size()) * width) / 2;
        const int line = (row.y - bars_top_) / scale_ - 3;
        for (int i = 0; i < static_cast<int>(bars.size()); ++i) {
            const Bar& bar = bars[static_cast<std::size_t>(i)];
            const int bar_left = left + i * width;
            row.fill(bar_left, width, row.ink(bar.colour));
            if (line >= 0 && line < small_font::letter_height)
                small_font::draw_line(row, bar.letter,
                                      bar_left + (width - small_font::letter_width * scale_) / 2, scale_,
                                      line, Colour{});
        }
    }

    template <PixelFormat format>
    void draw_frame(PixelRow<format> row) const
    {
        const Size panel = card_.panel();
        const auto white = row.ink(Colour{255, 255, 255});
        const bool is_end = row.y == 0 || row.y == panel.height - 1;
        row.fill(0, is_end ? panel.width : 1, white);
        row.fill(panel.width - 1, 1, white);
    }

    std::array<char, 12> size_text_;
    Card card_;
    int scale_ = 0;
    int bars_top_ = 0;
};

}

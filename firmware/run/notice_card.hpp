#pragma once

#include "firmware/run/card.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace kfast {

/// Breaks a text at its spaces into lines of at most `columns` letters. Returns how many lines it takes, or 0
/// if `lines` are too few or a word is too long.
constexpr std::size_t wrap(std::string_view text, std::size_t columns, std::span<std::string_view> lines)
{
    std::size_t count = 0;
    while (!text.empty()) {
        const std::size_t end = text.size() <= columns ? text.size() : text.rfind(' ', columns);
        if (count == lines.size() || end == text.npos)
            return 0;
        lines[count++] = text.substr(0, end);
        text.remove_prefix(std::min(text.size(), end + 1));
    }
    return count;
}

/// A title as large as the panel allows, and words that explain it where there is room. A panel that is too
/// small for the title stays black.
class NoticeCard {
public:
    /// Both texts must outlive the card.
    NoticeCard(std::string_view title, std::string_view words, Size panel) : card_{panel}
    {
        const int words_height = add_words(words);
        const int room = panel.height - words_height;
        const int scale =
            std::min(panel.width / (small_font::width(title) + 2), room / (small_font::letter_height + 2));
        if (scale > 0)
            card_.add(title, scale, (room - small_font::letter_height * scale) / 2);
    }
    NoticeCard(const NoticeCard&) = delete;

    template <PixelFormat format>
    void draw_row(PixelRow<format> row) const
    {
        card_.draw_row(row);
    }

private:
    static constexpr std::size_t max_lines = Card::max_lines - 1;

    /// Adds words in the lower half of the panel, as large as they fit. Returns the rows that they take.
    int add_words(std::string_view words)
    {
        const Size panel = card_.panel();
        std::array<std::string_view, max_lines> lines;
        for (int scale = panel.height / 2 / Card::line_height; scale > 0; --scale) {
            const int columns = (panel.width + scale) / (small_font::advance * scale);
            const std::size_t count = wrap(words, static_cast<std::size_t>(columns), lines);
            const int height = static_cast<int>(count) * Card::line_height * scale;
            if (count == 0 || height > panel.height / 2)
                continue;
            for (int i = 0; i < static_cast<int>(count); ++i)
                card_.add(lines[static_cast<std::size_t>(i)], scale,
                          panel.height - height + i * Card::line_height * scale);
            return height;
        }
        return 0;
    }

    Card card_;
};

}

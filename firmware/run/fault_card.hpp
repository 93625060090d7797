#pragma once

#include "core/bytes/result.hpp"
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

/// E and the number of an error as large as the panel allows, and what it means in words where there is room:
/// what a panel of at least 9 x 7 pixels, 13 x 7 for numbers of two digits, shows when nothing can be played.
/// A smaller one stays black.
class FaultCard {
public:
    FaultCard(Error error, Size panel) : number_{number_of(error)}, card_{panel}
    {
        const int words_height = add_words(error_text(error));
        const int room = panel.height - words_height;
        const int scale =
            std::min(panel.width / (small_font::width(number()) + 2), room / (small_font::letter_height + 2));
        if (scale > 0)
            card_.add(number(), scale, (room - small_font::letter_height * scale) / 2);
    }
    FaultCard(const FaultCard&) = delete;

    template <PixelFormat format>
    void draw_row(PixelRow<format> row) const
    {
        card_.draw_row(row);
    }

private:
    static constexpr std::size_t max_lines = Card::max_lines - 1;

    /// The text of a number of one or two digits.
    static constexpr std::array<char, 3> number_of(Error error)
    {
        const auto digit = [](int value) { return static_cast<char>('0' + value); };
        const int code = static_cast<int>(error);
        if (code < 10)
            return {'E', digit(code)};
        return {'E', digit(code / 10), digit(code % 10)};
    }
    std::string_view number() const { return {number_.data(), number_[2] == 0 ? std::size_t{2} : 3}; }

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

    std::array<char, 3> number_;
    Card card_;
};

}

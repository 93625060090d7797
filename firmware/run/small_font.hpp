#pragma once

#include "core/bytes/expects.hpp"
#include "core/pixel/pixel_row.hpp"

#include <array>
#include <cstdint>
#include <string_view>

namespace kfast {

/// Capitals, digits and a few signs of 3 x 5 blocks, for what a board must print without a scene. Letters are
/// four blocks apart.
namespace small_font {

inline constexpr int letter_width = 3;
inline constexpr int letter_height = 5;
inline constexpr int advance = letter_width + 1;

/// A row of blocks in each octal digit, the upper one first, the left block in the highest bit.
inline constexpr std::array<std::uint16_t, 26> capitals{
    025755, 065656, 034443, 065556, 074747, 074744, 034553, 055755, 072227, 011152, 055655, 044447, 057755,
    065555, 025552, 065644, 025563, 065655, 034216, 072222, 055557, 055552, 055775, 055255, 055222, 071247,
};
inline constexpr std::array<std::uint16_t, 10> digits{
    075557, 026227, 071747, 071717, 055711, 074717, 074757, 071222, 075757, 075717,
};

/// Lower case looks like capitals; letters without a sign are a block.
constexpr std::uint16_t blocks(char letter)
{
    if (letter >= 'a' && letter <= 'z')
        return capitals[static_cast<std::size_t>(letter - 'a')];
    if (letter >= 'A' && letter <= 'Z')
        return capitals[static_cast<std::size_t>(letter - 'A')];
    if (letter >= '0' && letter <= '9')
        return digits[static_cast<std::size_t>(letter - '0')];
    switch (letter) {
    case ' ':
    case '_':
        return 0;
    case '.':
        return 000002;
    case ',':
        return 000024;
    case ':':
        return 002020;
    case '-':
        return 000700;
    case '/':
        return 011244;
    case '^': // an arrow up
        return 027222;
    default:
        return 077777;
    }
}

/// In blocks, without the gap after the last letter.
constexpr int width(std::string_view text) { return static_cast<int>(text.size()) * advance - 1; }

/// Paints row `line` (0 … letter_height - 1) of a text that begins at column `left`, with blocks of `scale` x
/// `scale` pixels. The text is within the row.
template <PixelFormat format>
void draw_line(PixelRow<format> row, std::string_view text, int left, int scale, int line, Colour colour)
{
    expects(line >= 0 && line < letter_height);
    for (const char letter : text) {
        const int lit = blocks(letter) >> 3 * (letter_height - 1 - line);
        for (int column = 0; column < letter_width; ++column)
            if ((lit >> (letter_width - 1 - column) & 1) != 0)
                row.fill(left + column * scale, scale, row.ink(colour));
        left += advance * scale;
    }
}

}

}

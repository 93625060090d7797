#pragma once

#include "core/math/point.hpp"
#include "core/pixel/pixel_row.hpp"

#include <string>
#include <vector>

namespace kfast::test {

/// What a card paints, row by row: '.' black, '#' white, 'r', 'g', 'b', '?' anything else. The rows are
/// sullied before they are drawn.
template <PixelFormat format, class Card>
std::vector<std::string> drawn(const Card& card, Size panel)
{
    using Row = PixelRow<format>;
    const auto letter = [](std::uint32_t pixel) {
        return pixel == Row::ink({})                ? '.'
               : pixel == Row::ink({255, 255, 255}) ? '#'
               : pixel == Row::ink({255, 0, 0})     ? 'r'
               : pixel == Row::ink({0, 255, 0})     ? 'g'
               : pixel == Row::ink({0, 0, 255})     ? 'b'
                                                    : '?';
    };
    std::vector<std::string> rows;
    for (int y = 0; y < panel.height; ++y) {
        std::vector<std::byte> pixels(row_bytes(format, panel.width), std::byte{0x5A});
        card.draw_row(Row{pixels.data(), 0, y});
        std::string& text = rows.emplace_back();
        for (int x = 0; x < panel.width; ++x)
            text += letter(PixelCoding<format>::load(pixels.data(), x));
    }
    return rows;
}

}

#pragma once

#include "core/math/point.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace kfast {

/// How much of each pixel a letter covers, rows from the top; 255 is all.
struct LetterMask {
    Rect place; ///< from the left upper corner of the letter's cell
    std::vector<std::uint8_t> cover;
};

/// The letters of the preview's window, all as wide as Painter::letter.
class ScreenFont {
public:
    ScreenFont();
    ~ScreenFont();
    ScreenFont(const ScreenFont&) = delete;
    ScreenFont& operator=(const ScreenFont&) = delete;

    /// A box where the font has no such letter. Valid as long as the font.
    const LetterMask& letter(char32_t character);

private:
    class Face;
    std::unique_ptr<Face> face_;
};

}

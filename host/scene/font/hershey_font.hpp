#pragma once

#include "host/scene/font/font_shelf.hpp"

#include <span>
#include <string_view>

namespace kfast::scene {

/// A font that is part of this program, in the format that HersheyFont reads.
struct HersheyFace {
    std::string_view name;
    std::string_view jhf;
};

std::span<const HersheyFace> hershey_faces();

/// A font of Dr. A. V. Hershey in the JHF format of James Hurt, for the characters of ASCII from space to ~.
///
/// A glyph is a number in five columns, the count of its pairs in three, and the pairs: two characters each,
/// whose distances from R are x and y (down). The first pair is the left and the right edge of the letter, "
/// R" lifts the pen. Lines may end anywhere within the pairs.
///
/// Its capitals are 21 units high, the tallest brackets 32, which is the em: a capital is 21/32 of a text's
/// size. All segments are lines.
class HersheyFont : public Font {
public:
    /// Throws Failure when `jhf` breaks off, or holds anything but glyphs.
    explicit HersheyFont(std::string_view jhf);

    double units_per_em() const override { return 32; }
    const Letter* letter(char32_t character) override;
    double kerning(char32_t, char32_t) const override { return 0; }
    bool has_lines() const override { return true; }

private:
    std::vector<Letter> letters_;
};

}

#pragma once

#include "host/scene/font/font_shelf.hpp"

#include <memory>
#include <string>
#include <unordered_map>

namespace kfast::scene {

/// A font file with outlines (TrueType, OpenType, Type 1 …), read by FreeType. The outlines are used
/// unhinted; quadratic curves become the same cubic ones. Kerning comes from the table `kern`, where the file
/// has one.
class OutlineFont : public Font {
public:
    /// Throws Failure when `bytes` are no font, or one without outlines.
    explicit OutlineFont(std::string bytes);
    ~OutlineFont() override;

    double units_per_em() const override;
    const Letter* letter(char32_t character) override;
    double kerning(char32_t left, char32_t right) const override;
    bool has_lines() const override { return false; }

private:
    class Face;

    std::unique_ptr<Face> face_;
    std::unordered_map<char32_t, Letter> letters_; ///< those asked for so far
};

}

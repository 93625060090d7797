#pragma once

#include "host/geometry/outline.hpp"

#include <vector>

namespace kfast::scene {

/// The shape of a character in the units of its font: x to the right from where the letter begins, y down
/// from the baseline.
struct Letter {
    std::vector<Outline> outlines;
    double advance = 0; ///< from where it begins to where the next one does
};

/// Letters, whatever kind of file they come from.
class Font {
public:
    virtual ~Font() = default;

    /// The units that a text's size stands for.
    virtual double units_per_em() const = 0;
    /// Null when the font has no such character. Lives as long as the font.
    virtual const Letter* letter(char32_t character) = 0;
    /// What is added between these two letters, in units; most often less than 0.
    virtual double kerning(char32_t left, char32_t right) const = 0;
    /// Whether letters are lines, which a stroke makes visible, instead of outlines to fill.
    virtual bool has_lines() const = 0;
};

}

#pragma once

#include "core/math/point.hpp"
#include "core/scene/label_view.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// A glyph of a text and where it goes.
struct PlacedGlyph {
    std::uint32_t drawing = 0; ///< offset in the section of drawings
    Point origin;              ///< where the drawing's (0, 0) lies, in whole 1/16 px
};

/// Lays out a text by the advances of its glyphs, one after the other. Where each of them begins is rounded
/// once, to the nearest 1/16 px, halves to the right.
class LabelLayout {
public:
    /// `label` must outlive it; `glyphs` are numbers of the label's glyphs.
    LabelLayout(const LabelView& label, std::span<const std::byte> glyphs);

    bool at_end() const { return rest_.empty(); }
    /// Only when not at the end.
    PlacedGlyph next();

private:
    std::int32_t step() const;

    const LabelView& label_;
    std::span<const std::byte> rest_;
    std::int32_t x_; ///< where the next glyph begins, in 1/4096 px
};

}

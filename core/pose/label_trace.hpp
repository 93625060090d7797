#pragma once

#include "core/bytes/op_counter.hpp"
#include "core/math/affine.hpp"
#include "core/math/point.hpp"
#include "core/pose/deformed_drawing.hpp"
#include "core/pose/label_layout.hpp"
#include "core/pose/posed_strokes.hpp"
#include "core/scene/label_view.hpp"
#include "core/scene/packed_drawing.hpp"

#include <cstddef>
#include <span>

namespace kfast {

/// A text as a label shows it.
class LabelTrace {
public:
    /// `glyphs` are those of the text, `drawings` is the scene's section of drawings; both must outlive it.
    LabelTrace(const LabelView& label, std::span<const std::byte> glyphs, std::span<const std::byte> drawings)
        : label_{label}, glyphs_{glyphs}, drawings_{drawings}
    {
    }

    /// Where the first stroke begins; the origin if there is none.
    Point start() const;
    /// Adds the strokes of all glyphs, placed.
    template <class Outline>
    void trace(const Affine& placement, Outline& outline) const
    {
        for (LabelLayout layout{label_, glyphs_}; !layout.at_end();) {
            const PlacedGlyph glyph = layout.next();
            count_op(Op::object);
            DeformedDrawing drawing{PackedDrawing{drawings_, glyph.drawing, glyph.origin}};
            trace_strokes(drawing, placement, outline);
        }
    }

private:
    LabelView label_;
    std::span<const std::byte> glyphs_;
    std::span<const std::byte> drawings_;
};

}

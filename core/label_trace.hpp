#pragma once

#include "core/affine.hpp"
#include "core/label_view.hpp"
#include "core/object_outline.hpp"
#include "core/point.hpp"

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
    void trace(const Affine& placement, ObjectOutline& outline) const;

private:
    LabelView label_;
    std::span<const std::byte> glyphs_;
    std::span<const std::byte> drawings_;
};

}

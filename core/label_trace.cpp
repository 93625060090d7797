#include "core/label_trace.hpp"

#include "core/carried_drawing.hpp"
#include "core/label_layout.hpp"
#include "core/live_strokes.hpp"
#include "core/packed_drawing.hpp"
#include "core/work.hpp"

namespace kfast {

Point LabelTrace::start() const
{
    for (LabelLayout layout{label_, glyphs_}; !layout.at_end();) {
        const PlacedGlyph glyph = layout.next();
        PackedDrawing drawing{drawings_, glyph.drawing, glyph.origin};
        if (drawing.strokes() == 0)
            continue;
        drawing.next_stroke();
        return drawing.start();
    }
    return {};
}

void LabelTrace::trace(const Affine& placement, ObjectOutline& outline) const
{
    for (LabelLayout layout{label_, glyphs_}; !layout.at_end();) {
        const PlacedGlyph glyph = layout.next();
        did(Work::object);
        const CarriedDrawing drawing{PackedDrawing{drawings_, glyph.drawing, glyph.origin}};
        LiveStrokes{drawing, drawing, {}, nullptr, placement}.trace(outline);
    }
}

}

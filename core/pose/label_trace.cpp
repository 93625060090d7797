#include "core/pose/label_trace.hpp"

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

}

#include "core/drawing_check.hpp"

namespace kfast {

bool is_built_alike(PackedDrawing a, PackedDrawing b)
{
    if (a.strokes() != b.strokes())
        return false;
    for (std::uint32_t stroke = 0; stroke < a.strokes(); ++stroke) {
        const std::uint32_t segments = a.next_stroke();
        if (b.next_stroke() != segments)
            return false;
        for (std::uint32_t i = 0; i < segments; ++i)
            if (a.next_segment().kind != b.next_segment().kind)
                return false;
    }
    return true;
}

bool has_only_lines(PackedDrawing drawing)
{
    for (std::uint32_t stroke = 0; stroke < drawing.strokes(); ++stroke)
        for (std::uint32_t left = drawing.next_stroke(); left > 0; --left)
            if (drawing.next_segment().kind != Segment::Kind::line)
                return false;
    return true;
}

}

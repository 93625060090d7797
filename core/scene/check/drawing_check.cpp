#include "core/scene/check/scene_check.hpp"

#include "core/scene/packed_drawing.hpp"

namespace kfast {

bool is_built_alike(std::span<const std::byte> drawings, std::uint32_t one, std::uint32_t other)
{
    PackedDrawing a{drawings, one};
    PackedDrawing b{drawings, other};
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

bool has_only_lines(std::span<const std::byte> drawings, std::uint32_t offset)
{
    PackedDrawing drawing{drawings, offset};
    for (std::uint32_t stroke = 0; stroke < drawing.strokes(); ++stroke)
        for (std::uint32_t left = drawing.next_stroke(); left > 0; --left)
            if (drawing.next_segment().kind != Segment::Kind::line)
                return false;
    return true;
}

}

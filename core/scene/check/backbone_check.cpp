#include "core/scene/check/scene_check.hpp"

#include "core/scene/kfb_limits.hpp"
#include "core/scene/packed_drawing.hpp"

namespace kfast {

bool are_backbones(std::span<const std::byte> drawings, std::uint32_t offset)
{
    PackedDrawing drawing{drawings, offset};
    std::uint32_t all = 0;
    std::uint32_t nodes = 0;
    for (std::uint32_t stroke = 0; stroke < drawing.strokes(); ++stroke) {
        const std::uint32_t segments = drawing.next_stroke();
        if (stroke % 3 == 0) {
            nodes = segments;
            all += segments;
        }
        if (segments == 0 || segments != nodes)
            return false;
        for (std::uint32_t i = 0; i < segments; ++i)
            if (drawing.next_segment().kind != Segment::Kind::line)
                return false;
    }
    return drawing.strokes() != 0 && drawing.strokes() % 3 == 0 &&
           drawing.strokes() <= 3 * kfb::max_backbones && all <= kfb::max_backbone_segments;
}

}

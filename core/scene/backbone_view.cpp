#include "core/scene/backbone_view.hpp"

namespace kfast {

BackboneKeyCursor::BackboneKeyCursor(ByteReader& bytes)
    : beats_{BeatCursor::take(bytes, BeatCursor::one())}, drawings_{PackedValues::take(bytes, beats_.count())}
{
}

BackboneKey BackboneKeyCursor::next()
{
    const Beat beat = beats_.next();
    return {
        .time = beat.time, .laws = beat.laws, .drawing = static_cast<std::uint32_t>(drawings_[beat.index])};
}

std::size_t backbone_node_count(PackedDrawing drawing)
{
    std::size_t count = 0;
    for (std::uint32_t stroke = 0; stroke < drawing.strokes(); ++stroke) {
        const std::uint32_t segments = drawing.next_stroke();
        if (stroke % 3 == 0)
            count += segments + 2;
        for (std::uint32_t i = 0; i < segments; ++i)
            drawing.next_segment();
    }
    return count;
}

}

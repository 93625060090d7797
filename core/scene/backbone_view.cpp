#include "core/scene/backbone_view.hpp"

namespace kfast {

BackboneKeyCursor::BackboneKeyCursor(ByteReader& bytes)
    : key_times_{KeyTimeCursor::take(bytes, KeyTimeCursor::one())}, drawings_{PackedValues::take(
                                                                        bytes, key_times_.count())}
{
}

BackboneKey BackboneKeyCursor::next()
{
    const KeyTime key_time = key_times_.next();
    return {.time = key_time.time,
            .laws = key_time.laws,
            .drawing = static_cast<std::uint32_t>(drawings_[key_time.index])};
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

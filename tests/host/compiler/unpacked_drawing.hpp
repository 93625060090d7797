#pragma once

#include "core/scene/packed_drawing.hpp"
#include "host/scene/model.hpp"

#include <cstdint>

/// What the core reads, as the model has it.
namespace kfast::test {

inline scene::Point unpacked(Point point)
{
    const auto sixteenths = [](Fixed value) {
        return static_cast<std::int16_t>(value.raw() / (Fixed::one / 16));
    };
    return {sixteenths(point.x), sixteenths(point.y)};
}

inline scene::Drawing unpacked(PackedDrawing packed)
{
    scene::Drawing drawing;
    for (std::uint32_t stroke = 0; stroke < packed.strokes(); ++stroke) {
        const std::uint32_t segments = packed.next_stroke();
        scene::Stroke& read = drawing.strokes.emplace_back();
        read.from = unpacked(packed.start());
        for (std::uint32_t i = 0; i < segments; ++i) {
            const Segment segment = packed.next_segment();
            if (segment.kind == Segment::Kind::cubic)
                read.segments.push_back({.cubic = true,
                                         .c1 = unpacked(segment.c1),
                                         .c2 = unpacked(segment.c2),
                                         .to = unpacked(segment.to)});
            else
                read.segments.push_back({.cubic = false, .c1 = {}, .c2 = {}, .to = unpacked(segment.to)});
        }
    }
    return drawing;
}

}

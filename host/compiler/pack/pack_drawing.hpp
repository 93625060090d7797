#pragma once

#include "host/compiler/pack/byte_writer.hpp"
#include "host/compiler/pack/stroke_steps.hpp"
#include "host/scene/model.hpp"

#include <cstdint>

namespace kfast {

/// Appends `drawing` as the core's PackedDrawing reads it (docs/format.md, "Drawings"). add_form(steps,
/// bytes) appends the form of a stroke.
template <class AddForm>
void pack_drawing(const scene::Drawing& drawing, ByteWriter& bytes, AddForm add_form)
{
    bytes.varint(static_cast<std::uint32_t>(drawing.strokes.size()));
    scene::Point before;
    for (const scene::Stroke& stroke : drawing.strokes) {
        bytes.signed_varint(stroke.from.x - before.x);
        bytes.signed_varint(stroke.from.y - before.y);
        add_form(steps_of(stroke), bytes);
        before = stroke.from;
    }
}

/// By itself: no form lies elsewhere.
void pack_drawing(const scene::Drawing& drawing, ByteWriter& bytes);

}

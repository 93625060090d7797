#pragma once

#include "host/compiler/pack/byte_writer.hpp"
#include "host/scene/model.hpp"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace kfast {

/// The difference of two points, in 1/16 px.
struct Delta {
    std::int32_t x = 0;
    std::int32_t y = 0;

    friend auto operator<=>(const Delta&, const Delta&) = default;
    friend Delta operator-(Delta a) { return {-a.x, -a.y}; }
    friend Delta operator+(Delta a, Delta b) { return {a.x + b.x, a.y + b.y}; }
    friend Delta operator-(Delta a, Delta b) { return {a.x - b.x, a.y - b.y}; }
};

/// A segment, wherever it begins.
struct Step {
    bool cubic = false;
    Delta end = {};  ///< from the beginning
    Delta c1 = {};   ///< from the beginning
    Delta back = {}; ///< the second control point from the end

    friend auto operator<=>(const Step&, const Step&) = default;
};

/// A stroke, wherever it begins.
using Steps = std::vector<Step>;

Steps steps_of(const scene::Stroke& stroke);
/// The steps with x, y or both mirrored.
Steps mirrored(const Steps& steps, bool x, bool y);

/// The form of a stroke as the core's PackedDrawing reads it (docs/format.md, "Forms"), in as few bytes as
/// it takes.
std::vector<std::byte> packed_form(const Steps& steps);

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

/// By itself: no form is stored elsewhere.
void pack_drawing(const scene::Drawing& drawing, ByteWriter& bytes);

}

#include "core/pose/input_drawings.hpp"

#include "core/feature_code.hpp"

#include <algorithm>

namespace kfast {
namespace {

std::size_t bytes_for(const InputView& input)
{
    return input.type == InputType::drawing ? InputDrawing::bytes_for(input.drawing) : 0;
}

InputPoint live_point(Point at)
{
    constexpr int sixteenth_bits = 12;
    return {static_cast<std::int16_t>(at.x.raw() >> sixteenth_bits),
            static_cast<std::int16_t>(at.y.raw() >> sixteenth_bits)};
}

/// `drawing` has no more than `live` holds (SceneView::parse).
void show(PackedDrawing drawing, InputDrawing live)
{
    live.begin();
    for (std::uint32_t left = drawing.strokes(); left > 0; --left) {
        std::uint32_t segments = drawing.next_stroke();
        live.begin_stroke();
        live.add(live_point(drawing.start()));
        for (; segments > 0; --segments)
            live.add(live_point(drawing.next_segment().to));
    }
    live.show();
}

}

std::size_t InputDrawings::bytes_for(const SceneView& scene)
{
    std::size_t bytes = 0;
    for (InputCursor inputs = scene.inputs(); !inputs.at_end();)
        bytes += kfast::bytes_for(inputs.next());
    return bytes;
}

InputDrawings::InputDrawings(const SceneView& scene, std::span<std::byte> memory) : memory_{memory}
{
    std::ranges::fill(memory, std::byte{});
    if (!memory.empty())
        scene.features().drawings->show_default(*this, scene);
}

void InputDrawings::show_default(const SceneView& scene) const
{
    InputCursor inputs = scene.inputs();
    for (std::uint32_t number = 0; !inputs.at_end(); ++number) {
        const InputView input = inputs.next();
        if (input.type == InputType::drawing)
            show(scene.drawing(input.drawing.default_value), of(scene, number));
    }
}

InputDrawing InputDrawings::of(const SceneView& scene, std::uint32_t number) const
{
    std::size_t before = 0;
    InputCursor inputs = scene.inputs();
    for (; number > 0; --number)
        before += kfast::bytes_for(inputs.next());
    return {memory_.subspan(before), inputs.next().drawing};
}

}

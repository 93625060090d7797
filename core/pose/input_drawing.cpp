#include "core/pose/input_drawing.hpp"

#include "core/features.hpp"

#include <algorithm>

namespace kfast {

namespace {

static_assert(sizeof(InputPoint) == 4);

/// Bytes for one drawing; a multiple of 4.
constexpr std::size_t bytes_of_strokes(std::size_t strokes) { return (strokes + 1) / 2 * 4; }

constexpr std::size_t bytes_of_drawing(std::size_t strokes, std::size_t points)
{
    return bytes_of_strokes(strokes) + points * sizeof(InputPoint);
}

}

std::size_t InputDrawing::bytes_for(const DrawingInput& limits)
{
    return sizeof(Head) + 2 * bytes_of_drawing(limits.strokes, limits.points);
}

InputDrawing::InputDrawing(std::span<std::byte> memory, const DrawingInput& limits)
    : head_{reinterpret_cast<Head*>(memory.data())}, max_strokes_{limits.strokes}, max_points_{limits.points}
{
}

std::uint16_t* InputDrawing::ends(std::size_t drawing) const
{
    std::byte* const first = reinterpret_cast<std::byte*>(head_ + 1);
    return reinterpret_cast<std::uint16_t*>(first + drawing * bytes_of_drawing(max_strokes_, max_points_));
}

InputPoint* InputDrawing::points(std::size_t drawing) const
{
    return reinterpret_cast<InputPoint*>(reinterpret_cast<std::byte*>(ends(drawing)) +
                                         bytes_of_strokes(max_strokes_));
}

InputStroke InputDrawing::stroke(std::uint32_t number) const
{
    const std::uint16_t* const ends_of_shown = ends(head_->shown);
    const std::size_t first = number == 0 ? 0 : ends_of_shown[number - 1];
    return {points(head_->shown) + first, ends_of_shown[number] - first};
}

void InputDrawing::begin()
{
    next() = {};
    head_->has_stroke = 0;
    head_->mark = 0;
}

bool InputDrawing::add(InputPoint point)
{
    Counts& counts = next();
    if (counts.points == max_points_ || (head_->has_stroke == 0 && counts.strokes == max_strokes_))
        return false;
    if (head_->has_stroke == 0)
        ++counts.strokes;
    head_->has_stroke = 1;
    points(next_number())[counts.points++] = point;
    ends(next_number())[counts.strokes - 1] = counts.points;
    return true;
}

bool InputDrawing::show()
{
    const bool differs = !is_same();
    head_->shown = static_cast<std::uint16_t>(next_number());
    begin();
    return differs;
}

bool InputDrawing::is_same() const
{
    const Counts& a = head_->drawings[0];
    const Counts& b = head_->drawings[1];
    return a.strokes == b.strokes && a.points == b.points &&
           std::equal(ends(0), ends(0) + a.strokes, ends(1)) &&
           std::equal(points(0), points(0) + a.points, points(1));
}

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

/// Shows `drawing`, which has no more than `live` can hold (SceneView::parse).
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

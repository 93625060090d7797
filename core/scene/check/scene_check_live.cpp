#include "core/feature_code.hpp"
#include "core/scene/check/scene_check.hpp"

/// What of a scene comes from outside.
namespace kfast {

bool SceneCheck::check_inputs()
{
    if (!are_inputs_valid(scene_))
        return false;
    InputCursor inputs = scene_.inputs();
    for (std::uint32_t number = 0; !inputs.at_end(); ++number) {
        const InputView input = inputs.next();
        if (input.type == InputType::number)
            scene_.number_inputs_ |= bit_of_input(number);
        if (input.type == InputType::text && !needs(Feature::texts))
            return false;
        if (input.type == InputType::drawing &&
            (!needs(Feature::drawings) || !scene_.features().drawings->check(*this, input.drawing)))
            return false;
    }
    return true;
}

bool SceneCheck::check_default(const DrawingInput& input)
{
    if (!check_drawing(input.default_value))
        return false;
    PackedDrawing drawing = scene_.drawing(input.default_value);
    std::uint32_t points = drawing.strokes();
    for (std::uint32_t stroke = 0; stroke < drawing.strokes(); ++stroke) {
        const std::uint32_t segments = drawing.next_stroke();
        points += segments;
        for (std::uint32_t i = 0; i < segments; ++i)
            if (drawing.next_segment().kind != Segment::Kind::line)
                return false;
    }
    return drawing.strokes() <= input.strokes && points <= input.points;
}

bool SceneCheck::check_live(const ItemView& item)
{
    const auto input = input_at(item.live.input);
    if (!input || !check_style(item.object.style))
        return false;
    switch (item.live.kind) {
    case InputLeaf::drawing:
        points_ = input->drawing.points;
        return input->type == InputType::drawing;
    case InputLeaf::label:
        return input->type == InputType::text &&
               scene_.features().texts->check(*this, LabelView::of(item.live.label), input->text);
    }
    return false;
}

bool SceneCheck::check_label(const LabelView& label, const TextInput& text)
{
    if (!is_label_valid(label, text))
        return false;
    for (std::uint32_t glyph = 0; glyph < label.glyph_count; ++glyph)
        if (!check_drawing(static_cast<std::uint32_t>(label.drawings[glyph])))
            return false;
    points_ *= text.max;
    return true;
}

std::optional<InputView> SceneCheck::input_at(std::uint32_t number) const
{
    return number < scene_.input_count() ? std::optional{scene_.input(number)} : std::nullopt;
}

}

#include "core/features.hpp"
#include "core/scene/check/scene_check.hpp"
#include "core/scene/format.hpp"
#include "core/scene/kfb_limits.hpp"
#include "core/scene/number_text.hpp"

#include <algorithm>
#include <span>

namespace kfast {

namespace {

bool is_value(std::int32_t value) { return value >= -kfb::max_input_value && value <= kfb::max_input_value; }

bool is_valid_number(const InputView& input)
{
    return is_value(input.min) && is_value(input.max) && input.max > input.min &&
           input.default_value >= input.min && input.default_value <= input.max;
}

bool is_valid(const TextInput& text)
{
    const auto is_glyph = [&text](std::byte glyph) {
        return std::to_integer<std::uint32_t>(glyph) < text.glyphs.count();
    };
    return text.max >= 1 && text.max <= kfb::max_text && text.glyphs.is_valid() &&
           text.default_value.size() <= text.max && std::ranges::all_of(text.default_value, is_glyph);
}

bool is_valid(const InputView& input)
{
    switch (input.type) {
    case InputType::number:
        return is_valid_number(input);
    case InputType::drawing:
        return input.drawing.strokes >= 1 && input.drawing.strokes <= input.drawing.points &&
               input.drawing.points <= kfb::max_live_points;
    case InputType::text:
        return is_valid(input.text);
    }
    return false;
}

}

bool are_inputs_valid(const SceneView& scene)
{
    InputCursor inputs = scene.inputs();
    while (!inputs.at_end()) {
        const InputView input = inputs.next();
        if (inputs.rest().overrun() || input.name.empty() || !is_valid(input))
            return false;
    }
    return scene.input_count() <= kfb::max_inputs && inputs.rest().left() == 0;
}

namespace {

bool is_coordinate(std::int32_t sixteenths)
{
    return sixteenths >= kfb::min_coordinate && sixteenths <= kfb::max_coordinate;
}

bool is_width(std::int32_t width) { return width >= -kfb::max_text_width && width <= kfb::max_text_width; }

/// The largest absolute value of `count` values; beyond kfb::max_text_width it stays beyond it.
std::int32_t largest(const PackedValues& values, std::uint32_t count)
{
    std::int32_t max = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (!is_width(values[i]))
            return kfb::max_text_width + 1;
        max = std::max(max, values[i] < 0 ? -values[i] : values[i]);
    }
    return max;
}

bool are_pairs_valid(const LabelView& label)
{
    for (std::uint32_t i = 0; i < label.pair_count(); ++i) {
        const std::uint32_t code = label.pair_code(i);
        if (kfb::kerning::left.get(code) >= label.glyph_count ||
            kfb::kerning::right.get(code) >= label.glyph_count || (i != 0 && code <= label.pair_code(i - 1)))
            return false;
    }
    return true;
}

bool are_glyphs(std::span<const std::byte> glyphs, const LabelView& label)
{
    return std::ranges::all_of(glyphs, [&label](std::byte glyph) {
        return std::to_integer<std::uint32_t>(glyph) < label.glyph_count;
    });
}

bool is_valid(const NumberFormat& format, const LabelView& label)
{
    return format.decimals <= kfb::max_decimals && format.digits >= 1 && format.digits <= kfb::max_digits &&
           format.places <= kfb::max_digits &&
           format.before.size() + format.behind.size() <= kfb::max_around &&
           are_glyphs(format.before, label) && are_glyphs(format.behind, label);
}

/// Whether what it shows is of the kind of the input, in glyphs that there are.
bool shows(const LabelView& label, const InputView& input)
{
    if (label.shows_number)
        return input.type == InputType::number && label.glyph_count >= kfb::number_glyph::first_other &&
               is_valid(label.format, label);
    return input.type == InputType::text && label.glyph_count == input.text.glyphs.count();
}

std::uint32_t max_glyphs(const LabelView& label, const InputView& input)
{
    return label.shows_number ? max_glyphs(label.format, input) : input.text.max;
}

bool fits(const LabelView& label, const InputView& input)
{
    if (!is_width(label.spacing))
        return false;
    const std::int32_t spacing = label.spacing < 0 ? -label.spacing : label.spacing;
    const std::int32_t step =
        largest(label.advances, label.glyph_count) + largest(label.kerning, label.pair_count()) + spacing;
    return static_cast<std::uint32_t>(step) <= std::uint32_t{kfb::max_text_width} / max_glyphs(label, input);
}

}

bool is_label_valid(const LabelView& label, const InputView& input)
{
    return label.is_whole && shows(label, input) && label.align <= Align::right && is_coordinate(label.x) &&
           is_coordinate(label.y) && are_pairs_valid(label) && fits(label, input);
}

/// The parts of a scene that come from outside.

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
        strokes_ = input->drawing.strokes;
        return input->type == InputType::drawing;
    case InputLeaf::label:
        return needs(Feature::texts) &&
               scene_.features().texts->check(*this, LabelView::of(item.live.label), *input);
    }
    return false;
}

bool SceneCheck::check_label(const LabelView& label, const InputView& input)
{
    if (!is_label_valid(label, input))
        return false;
    for (std::uint32_t glyph = 0; glyph < label.glyph_count; ++glyph)
        if (!check_drawing(static_cast<std::uint32_t>(label.drawings[glyph])))
            return false;
    points_ *= max_glyphs(label, input);
    strokes_ *= max_glyphs(label, input);
    return true;
}

std::optional<InputView> SceneCheck::input_at(std::uint32_t number) const
{
    return number < scene_.input_count() ? std::optional{scene_.input(number)} : std::nullopt;
}

}

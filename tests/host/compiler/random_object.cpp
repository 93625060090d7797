#include "tests/host/compiler/random_object.hpp"

#include "tests/host/compiler/random_drawing.hpp"
#include "tests/host/compiler/random_keys.hpp"
#include "tests/host/compiler/random_skin.hpp"

namespace kfast::test {
namespace {

constexpr std::size_t max_texts = 8;

void give_look(Dice& dice, scene::Object& object, std::size_t colours)
{
    if (dice.sometimes() || dice.sometimes())
        object.fill = dice.below(colours);
    if (!object.fill || dice.sometimes())
        object.stroke = scene::StrokeStyle{.colour = dice.below(colours),
                                           .width = dice.within(1, 400),
                                           .cap = static_cast<Cap>(dice.within(0, 2)),
                                           .join = static_cast<Join>(dice.within(0, 2)),
                                           .miter_limit = dice.within(8, 255)};
    if (object.fill)
        object.fill_rule = static_cast<FillRule>(dice.within(0, 1));
}

scene::Match random_match(Dice& dice) { return static_cast<scene::Match>(dice.within(0, 2)); }

/// The first strokes of letters.
std::vector<std::size_t> random_letters(Dice& dice, const scene::Drawing& drawing)
{
    std::vector<std::size_t> letters;
    for (std::size_t stroke = 0; stroke < drawing.strokes.size(); ++stroke)
        if (stroke == 0 || dice.sometimes())
            letters.push_back(stroke);
    return letters;
}

void give_keys(Dice& dice, scene::Object& object)
{
    RisingTimes times{dice};
    for (int left = dice.within(1, 4); left > 0; --left)
        object.keys.push_back({.time = times.next(),
                               .laws = random_laws(dice),
                               .match = random_match(dice),
                               .drawing = random_drawing(dice),
                               .place = {}});
    if (dice.sometimes())
        object.keys.back().drawing = object.keys.front().drawing;
    for (scene::Key& key : object.keys)
        key.letters = random_letters(dice, key.drawing);
}

scene::TextInput random_text(Dice& dice)
{
    scene::TextInput text{
        .glyphs = {}, .max = static_cast<std::uint32_t>(dice.within(1, 12)), .default_value = {}};
    char32_t character = U' ';
    for (int left = dice.within(1, 9); left > 0;
         --left, character += static_cast<char32_t>(dice.within(1, 3)))
        text.glyphs += character;
    for (int left = dice.within(0, static_cast<int>(text.max)); left > 0; --left)
        text.default_value += text.glyphs[dice.below(text.glyphs.size())];
    return text;
}

scene::Label random_label(Dice& dice, std::size_t input, std::size_t glyphs)
{
    scene::Label label{.input = input,
                       .at = random_point(dice),
                       .pivot = {},
                       .align = static_cast<Align>(dice.within(0, 2)),
                       .spacing = dice.within(-9000, 9000),
                       .glyphs = {},
                       .kerning = {}};
    for (std::size_t i = 0; i < glyphs; ++i)
        label.glyphs.push_back({random_drawing(dice), dice.within(-9000, 200'000)});
    for (std::size_t i = 0; i < glyphs; ++i)
        if (dice.sometimes())
            label.kerning.push_back({static_cast<std::uint8_t>(i),
                                     static_cast<std::uint8_t>(dice.below(glyphs)), dice.within(1, 5000)});
    return label;
}

scene::NumberFormat random_format(Dice& dice, std::size_t glyphs)
{
    const auto any_glyphs = [&dice, glyphs](int max) {
        std::vector<std::uint8_t> numbers;
        for (int left = dice.within(0, max); left > 0; --left)
            numbers.push_back(static_cast<std::uint8_t>(dice.below(glyphs)));
        return numbers;
    };
    return {.decimals = static_cast<std::uint32_t>(dice.within(0, 3)),
            .digits = static_cast<std::uint32_t>(dice.within(1, 4)),
            .places = static_cast<std::uint32_t>(dice.within(0, 5)),
            .before = any_glyphs(3),
            .behind = any_glyphs(2)};
}

void show_number(Dice& dice, scene::Object& object, std::vector<scene::Input>& inputs)
{
    const auto glyphs = static_cast<std::size_t>(dice.within(13, 16));
    object.keys.clear();
    object.label = random_label(dice, inputs.size(), glyphs);
    object.label->format = random_format(dice, glyphs);
    inputs.push_back({.name = {}, .min = -dice.within(0, 90'000), .max = dice.within(1, 90'000)});
}

void show_text(Dice& dice, scene::Object& object, std::vector<scene::Input>& inputs)
{
    if (inputs.size() == max_texts)
        return;
    if (dice.sometimes())
        return show_number(dice, object, inputs);
    const scene::TextInput text = random_text(dice);
    object.keys.clear();
    object.label = random_label(dice, inputs.size(), text.glyphs.size());
    inputs.push_back({.name = {}, .type = InputType::text, .text = text});
}

/// A skin needs as many strokes in all drawings that are not empty.
void cover_with_skin(Dice& dice, scene::Object& object, const std::vector<scene::Bones>& skeletons)
{
    const int strokes = dice.within(1, 3);
    const scene::Drawing* first = nullptr;
    for (scene::Key& key : object.keys) {
        key.match = scene::Match::count;
        key.drawing = dice.sometimes() ? scene::Drawing{} : random_drawing(dice, strokes);
        if (first == nullptr && !key.drawing.strokes.empty())
            first = &key.drawing;
    }
    object.skin = random_skin(dice, skeletons, dice.below(skeletons.size()),
                              first != nullptr ? *first : scene::Drawing{});
}

std::vector<scene::BackboneKey> random_backbone_keys(Dice& dice)
{
    std::vector<int> sizes;
    for (int left = dice.within(1, 3); left > 0; --left)
        sizes.push_back(dice.within(2, 5));
    std::vector<scene::BackboneKey> keys;
    RisingTimes times{dice};
    for (int left = dice.within(1, 3); left > 0; --left) {
        keys.push_back({.time = times.next(), .laws = random_laws(dice), .backbones = {}, .place = {}});
        for (const int size : sizes)
            keys.back().backbones.push_back(
                {random_points(dice, size), random_points(dice, size), random_points(dice, size)});
    }
    return keys;
}

/// Of lines, with a depth for each of their points.
void make_wires(Dice& dice, scene::Object& object)
{
    object.fill.reset();
    object.has_depths = true;
    for (scene::Key& key : object.keys) {
        key.match = scene::Match::count;
        for (scene::Stroke& stroke : key.drawing.strokes)
            for (scene::Segment& segment : stroke.segments)
                segment = {.cubic = false, .c1 = {}, .c2 = {}, .to = segment.to};
        key.depths = key.drawing;
        for (scene::Stroke& stroke : key.depths.strokes) {
            stroke.from = {random_point(dice).x, 0};
            for (scene::Segment& segment : stroke.segments)
                segment.to = {random_point(dice).x, 0};
        }
    }
}

/// Draws no random number: scenes stay what they are without it.
BeamStyle beam_style(const scene::Object& object, Time time)
{
    BeamStyle style{.parts = static_cast<BeamParts>(time.ticks & (object.fill ? 3 : 1))};
    if (style.has_hatching()) {
        style.spacing = 8 + time.ticks % 1000;
        style.direction = BinaryAngle::from_raw(time.ticks);
    }
    return style;
}

}

scene::Object random_object(Dice& dice, scene::Scene& scene)
{
    scene::Object object;
    give_look(dice, object, scene.palette.size());
    give_keys(dice, object);
    const Time last = object.keys.back().time;
    if (dice.below(8) == 0)
        show_text(dice, object, scene.inputs);
    else if (!scene.bones.empty() && dice.sometimes())
        cover_with_skin(dice, object, scene.bones);
    else if (dice.below(8) == 0)
        object.backbone_keys = random_backbone_keys(dice);
    else if (object.stroke && dice.sometimes())
        make_wires(dice, object);
    object.beam = beam_style(object, last);
    return object;
}

}

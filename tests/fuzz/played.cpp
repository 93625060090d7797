#include "tests/fuzz/played.hpp"

#include "core/player.hpp"
#include "core/scene/input_view.hpp"
#include "host/text/characters.hpp"
#include "host/walk/every_item.hpp"
#include "tests/demand.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace kfast {
namespace {

using Bytes = std::vector<std::byte>;

constexpr Size panel{24, 17};
constexpr std::size_t max_drawn_bytes = 20000; ///< of outlines; more take too long for a fuzzer

/// Names and times of marks are what parse() promises.
void read_marks(const SceneView& scene)
{
    for (ClipCursor clips = scene.clips(); !clips.at_end();) {
        const ClipView clip = clips.next();
        demand(scene.clip(clip.name).has_value() && clip.begin < clip.end && clip.end <= scene.length());
    }
    Time before;
    for (EventCursor events = scene.events(); !events.at_end();) {
        const EventView event = events.next();
        demand(!event.name.empty() && event.time >= before && event.time <= scene.length());
        before = event.time;
    }
}

void read_drawing(PackedDrawing drawing)
{
    for (std::uint32_t stroke = 0; stroke < drawing.strokes(); ++stroke)
        for (std::uint32_t left = drawing.next_stroke(); left > 0; --left)
            drawing.next_segment();
    demand(drawing.is_valid());
}

void read_text(const TextInput& text)
{
    for (std::uint32_t glyph = 0; glyph < text.glyphs.count(); ++glyph)
        demand(text.glyphs.glyph(text.glyphs.character(glyph)) == glyph);
    demand(text.default_value.size() <= text.max);
}

void read_inputs(const SceneView& scene)
{
    for (InputCursor inputs = scene.inputs(); !inputs.at_end();) {
        const InputView input = inputs.next();
        demand(scene.input(input.name).has_value());
        if (input.type == InputType::drawing) {
            read_drawing(scene.drawing(input.drawing.default_value));
            continue;
        }
        const Time place = input.place_of(input.default_value);
        demand(scene.input(input.name).has_value() && place >= Time{} && place <= whole_input);
        if (input.type == InputType::text)
            read_text(input.text);
    }
}

void read_tracks(const SceneView& scene, TrackCursor tracks)
{
    while (!tracks.at_end()) {
        TrackKeyCursor keys = tracks.next().keys;
        while (!keys.at_end())
            demand(is_valid(scene.laws(keys.next().laws).y));
    }
}

void read_bones(const SceneView& scene)
{
    std::uint32_t all = 0;
    for (SkeletonCursor skeletons = scene.skeletons(); !skeletons.at_end();) {
        const SkeletonView bones = skeletons.next();
        demand(bones.count() != 0);
        all += bones.count();
        for (KeyTimeCursor key_times = bones.common_key_times(); !key_times.at_end();)
            demand(is_valid(scene.laws(key_times.next().laws).x));
        for (BoneCursor cursor = bones.bones(); !cursor.at_end();)
            demand(cursor.next().at_rest(BoneQuantity::length) > 0);
    }
    demand(all == scene.bone_count());
}

void read_keys(const SceneView& scene, const ObjectView& object)
{
    for (KeyCursor keys = object.keys(); !keys.at_end();) {
        const Key key = keys.next();
        demand(is_valid(scene.laws(key.laws).x));
        read_drawing(scene.drawing(key.drawing));
        if (object.has_arrivals)
            read_drawing(scene.drawing(key.arrival));
        if (object.deformer == Deformer::bones)
            demand(scene.skin(key.more).is_valid());
        if (object.has_depths)
            read_drawing(scene.drawing(static_cast<std::uint32_t>(key.more)));
    }
}

void read_backbones(const SceneView& scene, const BackbonesView& backbones)
{
    for (BackboneKeyCursor keys = backbones.keys(); !keys.at_end();) {
        const BackboneKey key = keys.next();
        read_drawing(scene.drawing(key.drawing));
        demand(backbone_node_count(scene.drawing(key.drawing)) <= scene.backbone_nodes());
    }
}

void read_label(const SceneView& scene, const LabelView& label)
{
    for (std::uint32_t glyph = 0; glyph < label.glyph_count; ++glyph)
        read_drawing(scene.drawing(static_cast<std::uint32_t>(label.drawings[glyph])));
}

/// Everything that a scene stores, items that are hidden or used nowhere too.
void read(const SceneView& scene)
{
    read_inputs(scene);
    read_marks(scene);
    read_bones(scene);
    every_item(scene, [&scene](const ItemView& item) {
        read_tracks(scene, item.tracks);
        if (item.path.is_known)
            read_drawing(scene.drawing(item.path.drawing));
        if (item.kind == ItemKind::object)
            read_keys(scene, item.object);
        if (item.kind == ItemKind::live && item.live.kind == InputLeaf::label)
            read_label(scene, LabelView::of(item.live.label));
        if (item.object.deformer == Deformer::backbones)
            read_backbones(scene, item.object.backbones);
    });
}

void draw(Player& player, PixelFormat format)
{
    Bytes pixels(row_bytes(format, panel.width) * panel.height);
    with_format(format, [&]<PixelFormat known>() { player.draw_rows<known>(panel.height, pixels); });
}

void draw_changes(Player& player, PixelFormat format)
{
    Bytes pixels(row_bytes(format, panel.width) * panel.height);
    const Size granularity{pixels_in_whole_bytes(format), 1};
    with_format(format, [&]<PixelFormat known>() {
        while (!player.draw_changes<known>(pixels, granularity, 11).empty())
            continue;
    });
}

/// Draws points from anywhere, now more and now fewer than there may be.
void scribble(Player& player, std::uint32_t input, std::uint32_t seed)
{
    InputDrawing drawing = player.drawing(input);
    const std::uint32_t max = player.scene().input(input).drawing.points;
    drawing.begin();
    for (std::uint32_t left = seed * 31 % (max + 2); left > 0; --left) {
        seed = seed * 1664525 + 1013904223;
        if (seed >> 28 == 0)
            drawing.begin_stroke();
        drawing.add({static_cast<std::int16_t>(seed >> 8), static_cast<std::int16_t>(seed >> 16)});
    }
    player.show_next_drawing(input);
}

void put(Player& player, std::uint32_t input, std::uint32_t round)
{
    if (player.scene().input(input).type == InputType::drawing)
        return scribble(player, input, round);
    player.set_input(input, {static_cast<std::int32_t>((round + input) * 9973 %
                                                       static_cast<std::uint32_t>(whole_input.ticks + 1))});
}

/// Tells all texts something else each time, longer than any may be.
void set_texts(const SceneView& scene, Player& player, std::size_t round)
{
    std::uint32_t number = 0;
    for (InputCursor inputs = scene.inputs(); !inputs.at_end(); ++number) {
        const InputView input = inputs.next();
        if (input.type != InputType::text)
            continue;
        std::string words;
        for (std::size_t i = 0; i < 70; ++i) {
            const auto glyph =
                static_cast<std::uint32_t>((round * 31 + i * (round % 3)) % input.text.glyphs.count());
            if (const char32_t character = input.text.glyphs.character(glyph); is_scalar_value(character))
                append_utf8(words, character);
        }
        player.set_text(number, round % 4 == 3 ? "" : words);
    }
}

}

void play(std::span<const std::byte> bytes)
{
    const auto scene = SceneView::parse(bytes);
    if (!scene)
        return;
    read(*scene);
    Bytes block(Player::block_bytes(*scene, panel));
    auto player = Player::create(*scene, panel, Fit::contain, block);
    demand(static_cast<bool>(player));
    const std::int32_t step = std::max(Time::ticks_per_frame / 2, scene->length().ticks / 50);
    std::size_t drawn = 0;
    for (Time time; time <= scene->length(); time.ticks += step) {
        for (std::uint32_t input = 0; input < scene->input_count(); ++input)
            put(*player, input, static_cast<std::uint32_t>(drawn));
        set_texts(*scene, *player, drawn);
        player->show(time);
        demand(player->picture().step_count <= scene->paint_steps());
        if (player->picture().outlines.needed_bytes() > max_drawn_bytes)
            continue;
        const PixelFormat format = pixel_formats[drawn++ % pixel_formats.size()];
        draw_changes(*player, format);
        draw(*player, format);
    }
}

}

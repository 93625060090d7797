#include "tests/fuzz/stored.hpp"

#include "core/scene/input_view.hpp"
#include "host/walk/every_item.hpp"
#include "tests/demand.hpp"

#include <cstdint>

namespace kfast::test {
namespace {

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

}

void read_all(const SceneView& scene)
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

}

#include "core/label_view.hpp"
#include "core/player.hpp"
#include "core/scene_view.hpp"
#include "host/compiler/backbone_timeline.hpp"
#include "host/compiler/carrier.hpp"
#include "host/compiler/even_stroke.hpp"
#include "host/compiler/key_writer.hpp"
#include "host/compiler/match_by_length.hpp"
#include "host/compiler/skinned_drawing.hpp"
#include "host/compiler/write_scene.hpp"
#include "tests/host/compiler/random_scene.hpp"
#include "tests/rounds.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <vector>

namespace kfast::test {
namespace {

scene::Point unpacked(Point point)
{
    const auto sixteenths = [](Fixed value) {
        return static_cast<std::int16_t>(value.raw() / (Fixed::one / 16));
    };
    return {sixteenths(point.x), sixteenths(point.y)};
}

scene::Drawing unpacked(PackedDrawing packed)
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

/// Compares what the core reads with the model that was written.
class Comparison {
public:
    Comparison(const SceneView& view, const scene::Scene& scene) : view_{view}, scene_{scene} {}

    void compare()
    {
        CHECK(view_.canvas() == scene_.canvas);
        CHECK(view_.frame_rate() == scene_.frame_rate);
        CHECK(view_.length() == scene_.length);
        CHECK(view_.loop() == scene_.loop);
        CHECK(view_.camera() == scene_.camera);
        REQUIRE(view_.palette_size() == scene_.palette.size());
        for (std::size_t i = 0; i < scene_.palette.size(); ++i)
            CHECK(view_.colour(i) == scene_.palette[i]);
        compare_inputs();
        compare_marks();
        compare_skeletons();
        REQUIRE(view_.symbol_count() == scene_.symbols.size());
        for (std::uint32_t i = 0; i < view_.symbol_count(); ++i)
            compare_items(view_.symbol(i), scene_.symbols[i].items);
        compare_items(view_.items(), scene_.items);
    }

private:
    void compare_inputs()
    {
        REQUIRE(view_.input_count() == scene_.inputs.size());
        InputCursor inputs = view_.inputs();
        for (const scene::Input& input : scene_.inputs) {
            const InputView read = inputs.next();
            CHECK(read.name == input.name);
            REQUIRE(read.type == input.type);
            if (input.type == InputType::drawing) {
                compare_drawing(read.drawing, input.drawing);
            } else if (input.type == InputType::text) {
                compare_text(read.text, input.text);
            } else {
                CHECK(read.least == input.least);
                CHECK(read.most == input.most);
                CHECK(read.usual == input.usual);
            }
        }
    }

    void compare_drawing(const DrawingInput& read, const scene::DrawingInput& drawing)
    {
        CHECK(read.strokes == drawing.strokes);
        CHECK(read.points == drawing.points);
        CHECK(unpacked(view_.drawing(read.usual)) == drawing.usual);
    }

    static void compare_text(const TextInput& read, const scene::TextInput& text)
    {
        CHECK(read.most == text.most);
        REQUIRE(read.glyphs.count() == text.glyphs.size());
        for (std::uint32_t glyph = 0; glyph < read.glyphs.count(); ++glyph)
            CHECK(read.glyphs.character(glyph) == text.glyphs[glyph]);
        REQUIRE(read.usual.size() == text.usual.size());
        for (std::size_t i = 0; i < text.usual.size(); ++i)
            CHECK(read.glyphs.character(std::to_integer<std::uint32_t>(read.usual[i])) == text.usual[i]);
    }

    void compare_marks()
    {
        ClipCursor clips = view_.clips();
        for (const scene::Clip& clip : scene_.clips) {
            REQUIRE(!clips.at_end());
            const ClipView read = clips.next();
            CHECK(read.name == clip.name);
            CHECK(read.begin == clip.begin);
            CHECK(read.end == clip.end);
            CHECK(read.loop == clip.loop);
        }
        CHECK(clips.at_end());
        EventCursor events = view_.events();
        for (const scene::Event& event : scene_.events) {
            REQUIRE(!events.at_end());
            const EventView read = events.next();
            CHECK(read.name == event.name);
            CHECK(read.time == event.time);
        }
        CHECK(events.at_end());
    }

    void compare_skeletons()
    {
        BonesCursor skeletons = view_.skeletons();
        for (const scene::Bones& skeleton : scene_.bones) {
            REQUIRE(!skeletons.at_end());
            const BonesView read = skeletons.next();
            REQUIRE(read.count() == skeleton.bones.size());
            BoneCursor bones = read.bones();
            for (const scene::Bone& bone : skeleton.bones)
                compare_bone(bones.next(), bone);
        }
        CHECK(skeletons.at_end());
    }

    void compare_bone(const BoneView& read, const scene::Bone& bone)
    {
        CHECK(read.parent == (bone.parent ? *bone.parent + 1 : 0));
        CHECK(read.is_at_tip == bone.is_at_tip);
        CHECK(read.set_up == bone.set_up);
        if (!bone.keys[0].empty())
            CHECK(read.turns_as_written == bone.turns_as_written);
        for (std::size_t i = 0; i < bone_quantity_count; ++i) {
            const bool is_modular = i == 0 && !bone.turns_as_written;
            compare_bone_keys(read.keys[i], bone.keys[i], is_modular);
            if (bone.keys[i].size() > 1) // a single one is the same by any clock
                CHECK(read.keys[i].keys().beats().clock() == bone.clock);
        }
    }

    void compare_bone_keys(const BoneKeys& read, const std::vector<scene::TrackKey>& keys, bool is_modular)
    {
        REQUIRE((read.kind() == BoneKeys::Kind::none) == keys.empty());
        TrackKeyCursor cursor = read.keys();
        for (const scene::TrackKey& key : keys) {
            REQUIRE_FALSE(cursor.at_end());
            const TrackKey stored = cursor.next();
            CHECK(stored.time == key.time);
            CHECK((is_modular ? stored.value & 0xFFFF : stored.value) == key.value);
            compare_laws(stored.laws, key.laws, &key == &keys.back());
        }
        CHECK(cursor.at_end());
    }

    void compare_items(ItemCursor cursor, const std::vector<scene::Item>& items)
    {
        for (const scene::Item& item : items) {
            REQUIRE(!cursor.at_end());
            const ItemView read = cursor.next();
            REQUIRE(read.kind == kind_of(item));
            compare_tracks(read.tracks, item);
            if (item.path)
                compare_path(read.path, *item.path);
            if (const auto* group = std::get_if<scene::Group>(&item.content))
                compare_items(ItemCursor{read.items}, group->items);
            else if (const auto* use = std::get_if<scene::Use>(&item.content))
                CHECK(read.symbol == use->symbol);
            else
                compare_shown(read, std::get<scene::Object>(item.content));
        }
        CHECK(cursor.at_end());
    }

    /// A track that is not stored must be one that changes nothing.
    void compare_tracks(TrackCursor cursor, const scene::Item& item)
    {
        for (const scene::Track& track : item.tracks) {
            TrackCursor ahead = cursor;
            if (!ahead.at_end() && ahead.next().property == track.property)
                compare_track(cursor.next(), track);
            else
                CHECK(changes_nothing(track, item));
        }
        CHECK(cursor.at_end());
    }

    static bool changes_nothing(const scene::Track& track, const scene::Item& item)
    {
        const auto* object = std::get_if<scene::Object>(&item.content);
        const std::int32_t value = track.keys.front().value;
        switch (track.property) {
        case Property::along:
            return false;
        case Property::scale_x:
        case Property::scale_y:
            return track.keys.size() == 1 && value == 4096;
        case Property::opacity:
            return track.keys.size() == 1 && value == 255;
        case Property::visible:
            return track.keys.size() == 1 && value == 1;
        case Property::fill:
            return track.keys.size() == 1 && static_cast<std::size_t>(value) == *object->fill;
        case Property::stroke:
            return track.keys.size() == 1 && static_cast<std::size_t>(value) == object->stroke->colour;
        case Property::width:
            return track.keys.size() == 1 && value == object->stroke->width;
        case Property::pivot_x:
        case Property::pivot_y:
            return (track.keys.size() == 1 && value == 0) || !needs_pivot(item);
        default:
            return track.keys.size() == 1 && value == 0;
        }
    }

    static bool needs_pivot(const scene::Item& item)
    {
        const auto* object = std::get_if<scene::Object>(&item.content);
        if (object != nullptr && object->has_depths)
            return true;
        return std::ranges::any_of(item.tracks, [&item](const scene::Track& track) {
            const bool is_of_pivot =
                (track.property >= Property::rotation_x && track.property <= Property::scale_y) ||
                track.property == Property::along;
            return is_of_pivot && !changes_nothing(track, item);
        });
    }

    void compare_track(const TrackView& read, const scene::Track& track)
    {
        REQUIRE(read.is_fixed == (track.keys.size() == 1));
        if (read.is_fixed) {
            CHECK(read.value == track.keys.front().value);
            return;
        }
        REQUIRE(read.is_smooth == track.is_smooth);
        CHECK(read.keys.beats().clock() == track.clock);
        TrackKeyCursor keys = read.keys;
        for (const scene::TrackKey& key : track.keys) {
            REQUIRE(!keys.at_end());
            const TrackKey stored = keys.next();
            CHECK(stored.time == key.time);
            CHECK(stored.value == key.value);
            compare_laws(stored.laws, track.is_smooth ? LawPair{} : key.laws, keys.at_end());
        }
        CHECK(keys.at_end());
    }

    void compare_path(const PathView& read, const scene::Path& path)
    {
        CHECK(read.turns == path.turns);
        const scene::Stroke stroke = rounded(made_even(measured(path.stroke)));
        CHECK(unpacked(view_.drawing(read.drawing)) == scene::Drawing{{stroke}});
        ByteReader lengths = read.lengths;
        for (const MeasuredSegment& segment : measured(stroke))
            CHECK(std::abs(lengths.varint() / 16.0 - segment.length) <= 1 / 16.0);
        CHECK(lengths.left() == 0);
    }

    void compare_laws(std::uint32_t number, const LawPair& laws, bool is_last)
    {
        CHECK(view_.laws(number) == (is_last ? LawPair{} : laws));
    }

    static ItemKind kind_of(const scene::Item& item)
    {
        const auto* object = std::get_if<scene::Object>(&item.content);
        return object != nullptr && (object->live || object->label)
                   ? ItemKind::live
                   : static_cast<ItemKind>(item.content.index());
    }

    void compare_shown(const ItemView& read, const scene::Object& object)
    {
        CHECK(read.beam == object.beam);
        if (object.label)
            compare_label(read, object);
        else if (object.live)
            compare_live_drawing(read, object);
        else
            compare_object(read.object, object);
    }

    void compare_live_drawing(const ItemView& read, const scene::Object& object)
    {
        compare_style(read.object.style, object);
        CHECK(read.live.kind == LiveKind::drawing);
        CHECK(read.live.input == *object.live);
    }

    void compare_label(const ItemView& read, const scene::Object& object)
    {
        compare_style(read.object.style, object);
        const scene::Label& label = *object.label;
        REQUIRE(read.live.kind == LiveKind::label);
        CHECK(read.live.input == label.input);
        const LabelView stored = LabelView::of(read.live.label);
        CHECK(stored.align == label.align);
        CHECK(stored.x == label.at.x);
        CHECK(stored.y == label.at.y);
        CHECK(stored.spacing == label.spacing);
        REQUIRE(stored.glyph_count == label.glyphs.size());
        for (std::uint32_t glyph = 0; glyph < stored.glyph_count; ++glyph) {
            CHECK(stored.advances[glyph] == label.glyphs[glyph].advance);
            CHECK(unpacked(view_.drawing(static_cast<std::uint32_t>(stored.drawings[glyph]))) ==
                  label.glyphs[glyph].drawing);
        }
        REQUIRE(stored.pair_count() == label.kerning.size());
        for (const scene::Kerning& pair : label.kerning)
            CHECK(stored.kerning_between(pair.left, pair.right) == pair.by);
    }

    void compare_object(const ObjectView& read, const scene::Object& object)
    {
        compare_style(read.style, object);
        REQUIRE(read.carrier == carrier_of(object));
        REQUIRE(read.has_depths == object.has_depths);
        if (object.skin)
            CHECK(read.skeleton == object.skin->bones);
        if (read.carrier == Carrier::backbones)
            compare_backbones(read, object);
        else
            compare_keys(read, object);
    }

    static void compare_style(const ObjectStyle& style, const scene::Object& object)
    {
        REQUIRE(style.is_filled == object.fill.has_value());
        REQUIRE(style.is_stroked == object.stroke.has_value());
        if (object.fill) {
            CHECK(style.fill == *object.fill);
            CHECK(style.fill_rule == object.fill_rule);
        }
        if (const auto& stroke = object.stroke) {
            CHECK(style.stroke == stroke->colour);
            CHECK(style.width == stroke->width);
            CHECK(style.cap == stroke->cap);
            CHECK(style.join == stroke->join);
            if (stroke->join == Join::miter)
                CHECK(style.miter_limit == stroke->miter_limit);
        }
    }

    void compare_keys(const ObjectView& read, const scene::Object& object)
    {
        KeyCursor keys = read.keys();
        CHECK(keys.beats().clock() == object.clock);
        for (std::size_t i = 0; i < object.keys.size(); ++i) {
            REQUIRE(!keys.at_end());
            const Key key = keys.next();
            CHECK(key.time == object.keys[i].time);
            compare_laws(key.laws, object.keys[i].laws, keys.at_end());
            if (object.skin)
                compare_skin(key, object, i);
            else
                compare_drawings(key, read.has_arrivals, object, i);
            if (object.has_depths)
                CHECK(unpacked(view_.drawing(static_cast<std::uint32_t>(key.more))) == object.keys[i].depths);
        }
        CHECK(keys.at_end());
    }

    void compare_backbones(const ObjectView& read, const scene::Object& object)
    {
        BackboneKeyCursor backbones = read.backbones.keys();
        if (object.backbone_keys.size() > 1)
            CHECK(backbones.beats().clock() == object.clock);
        for (const scene::BackboneKey& key : object.backbone_keys) {
            REQUIRE(!backbones.at_end());
            const BackboneKey stored = backbones.next();
            CHECK(stored.time == key.time);
            compare_laws(stored.laws, key.laws, backbones.at_end());
            CHECK(unpacked(view_.drawing(stored.drawing)) == drawing_of(key.backbones));
        }
        CHECK(backbones.at_end());
        compare_carried_keys(read, object);
    }

    void compare_carried_keys(const ObjectView& read, const scene::Object& object)
    {
        Diagnostics diagnostics;
        const KeyWays carried = key_ways(object, diagnostics);
        CHECK(read.backbones.unit_bits == carried.unit_bits);
        KeyCursor keys = read.keys();
        for (const KeyWay& way : carried.ways) {
            REQUIRE(!keys.at_end());
            const Key key = keys.next();
            CHECK(key.time == way.time);
            compare_laws(key.laws, way.laws, keys.at_end());
            CHECK(unpacked(view_.drawing(key.drawing)) == way.ends.from);
            if (read.has_arrivals)
                CHECK(unpacked(view_.drawing(key.arrival)) == way.ends.to);
        }
        CHECK(keys.at_end());
    }

    void compare_drawings(const Key& read, bool has_arrivals, const scene::Object& object, std::size_t i)
    {
        const scene::Key& key = object.keys[i];
        const scene::Key& next = object.keys[std::min(i + 1, object.keys.size() - 1)];
        MatchedDrawings expected{key.drawing, next.drawing};
        if (key.match == scene::Match::length && &next != &key)
            expected = *match_by_length(key.drawing, next.drawing);
        CHECK(unpacked(view_.drawing(read.drawing)) == expected.from);
        if (has_arrivals)
            CHECK(unpacked(view_.drawing(read.arrival)) == expected.to);
        else
            CHECK((key.match == scene::Match::count || &next == &key));
    }

    void compare_skin(const Key& read, const scene::Object& object, std::size_t i)
    {
        const auto first = std::ranges::find_if(
            object.keys, [](const scene::Key& key) { return !key.drawing.strokes.empty(); });
        const scene::Drawing& drawing = object.keys[i].drawing;
        const auto expected = skinned_drawing(first != object.keys.end() ? first->drawing : drawing,
                                              object.skin->bindings, drawing);
        REQUIRE(expected);
        CHECK(unpacked(view_.drawing(read.drawing)) == expected->drawing);
        SkinReader skin = view_.skin(read.more);
        REQUIRE(skin.has_drawing_at_rest() == expected->at_rest.has_value());
        if (expected->at_rest)
            CHECK(unpacked(view_.drawing(skin.drawing_at_rest())) == *expected->at_rest);
        REQUIRE(point_count(expected->drawing) == expected->bindings.size());
        for (const scene::Binding& binding : expected->bindings)
            compare_binding(skin.next(), binding);
    }

    static void compare_binding(const Binding& read, const scene::Binding& binding)
    {
        scene::Binding shares;
        read.each([&shares](BoneShare share) { shares.push_back({share.bone, share.weight}); });
        CHECK(shares == binding);
    }

    const SceneView& view_;
    const scene::Scene& scene_;
};

void play(const SceneView& scene, std::mt19937& random)
{
    constexpr Size panel{20, 30};
    std::vector<std::byte> block(Player::block_bytes(scene, panel));
    auto player = Player::create(scene, panel, Fit::contain, block);
    REQUIRE(player);
    for (int moment = 0; moment < 10; ++moment) {
        player->show({static_cast<std::int32_t>(random() % 200'000)});
        CHECK(player->picture().step_count <= scene.paint_steps());
    }
}

}

TEST_CASE("whatever is written comes back as it was, and can be played")
{
    std::mt19937 random{311};
    int written_scenes = 0;
    for (int round = 0; round < rounds(300); ++round) {
        const scene::Scene scene = random_scene(random);
        Diagnostics diagnostics;
        const auto bytes = write_scene(scene, diagnostics);
        if (!bytes)
            continue;
        const auto view = SceneView::parse(*bytes);
        REQUIRE(view);
        Comparison{*view, scene}.compare();
        play(*view, random);
        ++written_scenes;
    }
    CHECK(written_scenes > rounds(200));
}

}

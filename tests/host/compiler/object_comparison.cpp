#include "tests/host/compiler/object_comparison.hpp"

#include "core/scene/input_view.hpp"
#include "host/compiler/carry/backbone_timeline.hpp"
#include "host/compiler/carry/deformed_tweens.hpp"
#include "host/compiler/carry/skinned_drawing.hpp"
#include "host/compiler/match/match_by_letters.hpp"
#include "host/compiler/write/key_writer.hpp"
#include "tests/host/compiler/law_comparison.hpp"
#include "tests/host/compiler/unpacked_drawing.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <span>

namespace kfast::test {
namespace {

class ObjectComparison {
public:
    explicit ObjectComparison(const SceneView& view) : view_{view} {}

    void compare(const ItemView& read, const scene::Object& object)
    {
        CHECK(read.beam == object.beam);
        if (object.label)
            compare_label(read, object);
        else if (object.live)
            compare_live_drawing(read, object);
        else
            compare_drawn(read.object, object);
    }

private:
    void compare_live_drawing(const ItemView& read, const scene::Object& object)
    {
        compare_style(read.object.style, object);
        CHECK(read.live.kind == InputLeaf::drawing);
        CHECK(read.live.input == *object.live);
    }

    static void compare_format(const LabelView& stored, const scene::Label& label)
    {
        REQUIRE(stored.shows_number == label.format.has_value());
        if (!label.format)
            return;
        CHECK(stored.format.decimals == label.format->decimals);
        CHECK(stored.format.digits == label.format->digits);
        CHECK(stored.format.places == label.format->places);
        CHECK(std::ranges::equal(stored.format.before, std::as_bytes(std::span{label.format->before})));
        CHECK(std::ranges::equal(stored.format.behind, std::as_bytes(std::span{label.format->behind})));
    }

    void compare_label(const ItemView& read, const scene::Object& object)
    {
        compare_style(read.object.style, object);
        const scene::Label& label = *object.label;
        REQUIRE(read.live.kind == InputLeaf::label);
        CHECK(read.live.input == label.input);
        const LabelView stored = LabelView::of(read.live.label);
        CHECK(stored.align == label.align);
        CHECK(stored.x == label.at.x);
        CHECK(stored.y == label.at.y);
        CHECK(stored.spacing == label.spacing);
        compare_format(stored, label);
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

    void compare_drawn(const ObjectView& read, const scene::Object& object)
    {
        compare_style(read.style, object);
        REQUIRE(read.deformer == deformer_of(object));
        REQUIRE(read.has_depths == object.has_depths);
        if (object.skin)
            CHECK(read.skeleton == object.skin->bones);
        if (read.deformer == Deformer::backbones)
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
        CHECK(keys.key_times().driver() == object.driver);
        for (std::size_t i = 0; i < object.keys.size(); ++i) {
            REQUIRE(!keys.at_end());
            const Key key = keys.next();
            CHECK(key.time == object.keys[i].time);
            compare_laws(view_, key.laws, object.keys[i].laws, keys.at_end());
            if (object.skin)
                compare_skin(key, object, i);
            else
                compare_drawings(key, read.has_arrivals, object, i);
            if (object.has_depths)
                CHECK(unpacked(view_.drawing(static_cast<std::uint32_t>(key.more))) == object.keys[i].depths);
        }
        CHECK(keys.at_end());
    }

    void compare_drawings(const Key& read, bool has_arrivals, const scene::Object& object, std::size_t i)
    {
        const scene::Key& key = object.keys[i];
        const scene::Key& next = object.keys[std::min(i + 1, object.keys.size() - 1)];
        MatchedDrawings expected{key.drawing, next.drawing};
        if (&next != &key)
            expected = *matched_drawings(key, next, object.stroke.has_value());
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
        read.each([&shares](BoneInfluence share) { shares.push_back({share.bone, share.weight}); });
        CHECK(shares == binding);
    }

    void compare_backbones(const ObjectView& read, const scene::Object& object)
    {
        BackboneKeyCursor backbones = read.backbones.keys();
        if (object.backbone_keys.size() > 1)
            CHECK(backbones.key_times().driver() == object.driver);
        for (const scene::BackboneKey& key : object.backbone_keys) {
            REQUIRE(!backbones.at_end());
            const BackboneKey stored = backbones.next();
            CHECK(stored.time == key.time);
            compare_laws(view_, stored.laws, key.laws, backbones.at_end());
            CHECK(unpacked(view_.drawing(stored.drawing)) == drawing_of(key.backbones));
        }
        CHECK(backbones.at_end());
        compare_deformed_keys(read, object);
    }

    void compare_deformed_keys(const ObjectView& read, const scene::Object& object)
    {
        Diagnostics diagnostics;
        const KeyTweens deformed = key_tweens(object, diagnostics);
        CHECK(read.backbones.unit_bits == deformed.unit_bits);
        KeyCursor keys = read.keys();
        for (const KeyTween& tween : deformed.tweens) {
            REQUIRE(!keys.at_end());
            const Key key = keys.next();
            CHECK(key.time == tween.time);
            compare_laws(view_, key.laws, tween.laws, keys.at_end());
            CHECK(unpacked(view_.drawing(key.drawing)) == tween.ends.from);
            if (read.has_arrivals)
                CHECK(unpacked(view_.drawing(key.arrival)) == tween.ends.to);
        }
        CHECK(keys.at_end());
    }

    const SceneView& view_;
};

}

void compare_object(const SceneView& view, const ItemView& read, const scene::Object& object)
{
    ObjectComparison{view}.compare(read, object);
}

}

#include "core/features.hpp"

#include "core/scene/scene_view.hpp"
#include "tests/chosen_features.hpp"
#include "tests/core/raw_bones.hpp"
#include "tests/core/raw_drawing.hpp"
#include "tests/core/raw_label.hpp"

#include <doctest/doctest.h>

#include <optional>

/// What a program without a feature says of each place in a scene that needs it.
namespace kfast::test {
namespace {

Features all_but(Feature feature)
{
    return features_where([feature](Feature each) { return each != feature; });
}

/// Whether it is sound, and refused by name where the feature is missing.
bool needs(const RawScene& scene, Feature feature)
{
    const Bytes file = scene.file();
    REQUIRE(SceneView::parse(file));
    const auto refused = SceneView::parse(file, all_but(feature));
    return !refused && refused.error() == error_without(feature);
}

bool items_need(const Bytes& items, Feature feature)
{
    RawScene scene;
    scene.items = items;
    return needs(scene, feature);
}

/// An object with a drawing for each key, of RawScene.
Bytes changing(const std::vector<std::uint32_t>& drawings)
{
    std::vector<RawKey> keys;
    keys.reserve(drawings.size());
    for (const std::uint32_t drawing : drawings)
        keys.push_back({.time = Time::frame(static_cast<int>(keys.size())), .drawing = drawing});
    return joined({bytes({0x08, 1}), key_bytes(keys)});
}

/// An object that backbones carry, which are the first drawing; its own is at `drawing`.
Bytes on_backbones(std::uint32_t drawing)
{
    return joined({bytes({0x88, 1, 0, 9}), key_bytes({{}}), key_bytes({{.drawing = drawing}})});
}

}

TEST_CASE("pens, depth, paths and smooth tracks are features")
{
    CHECK(items_need(joined({bytes({0x10, 2, 1, 0x0A}), one_key()}), Feature::strokes));
    CHECK(items_need(tracked(1, smooth_track(Property::x, {{{}, 0, 1}, {{5}, 0, 2}})), Feature::smooth));
    for (const Property property : {Property::z, Property::rotation_x, Property::rotation_y})
        CHECK(items_need(tracked(1, fixed_track(property, 5)), Feature::depth));
    const Bytes along = joined({fixed_track(Property::along, 7), path_bytes(true, 0, {20, 20})});
    CHECK(items_need(joined({bytes({0x0C, 1}), along, bytes({1}), one_key()}), Feature::paths));
}

TEST_CASE("drawings that change are a feature, another one that stays is none")
{
    CHECK(items_need(changing({0, 10}), Feature::tweens));
    CHECK(items_need(changing({0, 0, 10}), Feature::tweens));
    CHECK_FALSE(items_need(changing({10, 10, 10}), Feature::tweens));
    CHECK(items_need(bytes({0x48, 1, 0, 20, 20}), Feature::tweens)); // arrival drawings
}

TEST_CASE("skeletons are a feature, even such that carry nothing, and so are other skins from key to key")
{
    RawScene scene;
    scene.bones = skeleton_bytes({{}, std::vector<RawBone>(2)});
    CHECK(needs(scene, Feature::bones));
    const auto carried_by = [](std::int32_t first, std::int32_t second) {
        return joined({bytes({0x88, 1, 1}), key_bytes({{.drawing = 10, .more = first},
                                                       {.time = {9}, .drawing = 10, .more = second}})});
    };
    scene.items = carried_by(-1, -2);
    CHECK(needs(scene, Feature::bones));
    CHECK(needs(scene, Feature::tweens));
    scene.items = carried_by(-1, -1);
    CHECK_FALSE(needs(scene, Feature::tweens));
}

TEST_CASE("backbones and wire frames are features, and what backbones carry changes")
{
    RawScene scene;
    RawDrawings drawings;
    const scene::Stroke row = polyline_of({{0, 0}, {160, 0}});
    drawings.add({{row, row, row}});
    const std::uint32_t one = drawings.add(scene::Drawing{{row}});
    scene.drawings = drawings.bytes();
    scene.items = on_backbones(one);
    CHECK(needs(scene, Feature::backbones));
    CHECK(needs(scene, Feature::tweens));
    scene.items = joined({bytes({0x13, 2, 1, 16, 0, 32}),
                          key_bytes({{.drawing = one, .more = static_cast<std::int32_t>(one)}})});
    CHECK(needs(scene, Feature::wires));
}

TEST_CASE("laws that spring or bounce are a feature, for either axis, and used or not")
{
    RawScene scene;
    scene.law_count = 1;
    for (const int kinds : {0x07, 0x70, 0xF7}) {
        scene.laws = bytes({kinds, 3, 0});
        CHECK(needs(scene, Feature::springs));
    }
    scene.laws = bytes({0x08, 0, 2, 0, 7, 0, 8, 0, 0, 0, 0x40});
    CHECK(needs(scene, Feature::springs));
}

TEST_CASE("inputs that are texts or drawings are features, shown or not")
{
    RawScene scene;
    scene.input_count = 1;
    scene.inputs = text_input_bytes("t", 8, 2, U'a', {0, 1});
    CHECK(needs(scene, Feature::texts));
    CHECK_FALSE(needs(scene, Feature::drawings));
    scene.inputs = bytes({2, 1, 'd', 1, 9, 10});
    CHECK(needs(scene, Feature::drawings));
    CHECK_FALSE(needs(scene, Feature::texts));
}

}

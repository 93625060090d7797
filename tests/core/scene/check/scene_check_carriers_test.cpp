#include "core/scene/check/scene_check.hpp"

#include "core/scene/kfb_limits.hpp"
#include "tests/core/acceptance.hpp"
#include "tests/core/raw_bones.hpp"
#include "tests/core/raw_drawing.hpp"
#include "tests/core/raw_skin.hpp"

#include <doctest/doctest.h>
#include <vector>

/// Objects that bones or backbones carry.
namespace kfast::test {
namespace {

/// Two lines, and one: five points.
scene::Drawing five_points()
{
    return {{polyline_of({{0, 0}, {160, 0}, {160, 160}}), polyline_of({{16, 16}, {32, 32}})}};
}

/// Drawings and skins as a test needs them, before those of RawScene.
struct DeformedScene {
    RawDrawings drawings;
    int bones = 3;
    Bytes object;

    bool is_taken() const
    {
        RawScene scene;
        scene.bones = skeleton_bytes({{}, std::vector<RawBone>(static_cast<std::size_t>(bones))});
        scene.law_count = 1;
        scene.laws = bytes({0x21});
        scene.drawings = drawings.bytes();
        scene.items = object;
        return is_accepted(scene);
    }
};

/// A filled object with the keys; the carrier is 0 for backbones.
Bytes deformed_object(const Bytes& deformer, const std::vector<RawKey>& keys, int more_bits = 0)
{
    return joined({bytes({0x88 | more_bits, 1}), deformer, key_bytes(keys)});
}

std::vector<RawKey> bone_key(std::uint32_t drawing, std::uint32_t skin)
{
    return {{.drawing = drawing, .more = static_cast<std::int32_t>(skin)}};
}

bool takes_skin(const scene::Drawing& drawing, const Bytes& skin)
{
    DeformedScene scene;
    const std::uint32_t at = scene.drawings.add(drawing);
    scene.object = deformed_object(bytes({1}), bone_key(at, scene.drawings.add(skin)));
    return scene.is_taken();
}

/// On five points.
bool takes_runs(const std::vector<RawRun>& runs) { return takes_skin(five_points(), skin_bytes(runs)); }

/// A drawing with a skin that names `at_rest`.
bool takes_at_rest(const scene::Drawing& drawing, const scene::Drawing& at_rest)
{
    DeformedScene scene;
    const std::uint32_t own = scene.drawings.add(drawing);
    const std::uint32_t rest = scene.drawings.add(at_rest);
    const auto points = static_cast<std::uint32_t>(scene::point_count(drawing));
    const std::uint32_t skin = scene.drawings.add(skin_bytes({{points, {{0}}}}, rest + 1));
    scene.object = deformed_object(bytes({1}), bone_key(own, skin));
    return scene.is_taken();
}

scene::Stroke row_of(int points)
{
    std::vector<scene::Point> at;
    at.reserve(static_cast<std::size_t>(points));
    for (int i = 0; i < points; ++i)
        at.push_back({static_cast<std::int16_t>(16 * i), static_cast<std::int16_t>(i % 2)});
    return polyline_of(at);
}

/// Three strokes of as many points for each.
scene::Drawing backbones_of(const std::vector<int>& points)
{
    scene::Drawing drawing;
    for (const int count : points)
        drawing.strokes.insert(drawing.strokes.end(), 3, row_of(count));
    return drawing;
}

struct RawBackboneKey {
    std::int32_t ticks;
    int laws;
    scene::Drawing drawing;
};

bool takes_backbones(int unit_bits, const std::vector<RawBackboneKey>& list)
{
    DeformedScene scene;
    std::vector<RawKey> keys;
    keys.reserve(list.size());
    for (const RawBackboneKey& key : list)
        keys.push_back({{key.ticks}, key.laws, scene.drawings.add(key.drawing)});
    const Bytes deformer = joined({bytes({0, unit_bits}), key_bytes(keys)});
    scene.object = deformed_object(deformer, {{.drawing = scene.drawings.add(five_points())}});
    return scene.is_taken();
}

bool takes_form(const scene::Drawing& drawing) { return takes_backbones(9, {{0, 0, drawing}}); }

}

TEST_CASE("a skin binds each point of its drawing, no more and no fewer")
{
    CHECK(takes_runs({{5, {{0}}}}));
    CHECK(takes_runs({{1, {{0}}}, {3, {{1}}}, {1, {{2}}}}));
    CHECK_FALSE(takes_runs({{6, {{0}}}}));
    CHECK_FALSE(takes_runs({{1, {{0}}}, {5, {{1}}}}));
    CHECK_FALSE(takes_runs({{4, {{0}}}})); // breaks off: the skin is the last in the section
    CHECK_FALSE(takes_runs({}));
    CHECK_FALSE(takes_skin(five_points(), {}));
    CHECK_FALSE(takes_skin(five_points(), bytes({0, 0x80})));
    CHECK(takes_skin({}, bytes({0}))); // the empty drawing has no points
    CHECK_FALSE(takes_skin({}, bytes({0x80})));
}

TEST_CASE("a skin names bones of its skeleton")
{
    CHECK(takes_runs({{5, {{2}}}}));
    CHECK_FALSE(takes_runs({{5, {{3}}}}));
    CHECK_FALSE(takes_runs({{4, {{0}}}, {1, {{255}}}}));
    CHECK(takes_runs({{5, {{2, 100}, {1, 65'436}}}}));
    CHECK_FALSE(takes_runs({{5, {{3, 25'600}, {1, 39'936}}}}));
    CHECK_FALSE(takes_runs({{5, {{1, 100}, {3, 65'436}}}}));
}

TEST_CASE("weights are at least 1, the rest that the last bone has too")
{
    CHECK(takes_runs({{5, {{0, 1}, {1, 65'535}}}}));
    CHECK(takes_runs({{5, {{0, 65'535}, {1, 1}}}}));
    CHECK_FALSE(takes_runs({{5, {{0, 0}, {1, 65'536}}}}));
    CHECK(takes_runs({{5, {{0, 1}, {1, 1}, {2, 65'533}, {0, 1}}}}));
    CHECK_FALSE(takes_runs({{5, {{0, 1}, {1, 1}, {2, 65'534}, {0, 0}}}}));
    CHECK_FALSE(takes_runs({{5, {{0, 51'200}, {1, 51'200}, {2, -36'864}}}}));
    CHECK_FALSE(takes_runs({{5, {{0, 51'201}, {1, 51'200}, {2, -36'865}}}}));
    CHECK_FALSE(takes_runs({{5, {{0, 512}, {1, 0}, {2, 65'024}}}}));
    CHECK_FALSE(takes_runs({{4, {{0}}}, {1, {{0, 0}, {1, 65'536}}}}));
}

TEST_CASE("the drawing at rest is built like the one that it stands for")
{
    scene::Drawing other = five_points();
    other.strokes[0].from = {300, 5};
    CHECK(takes_at_rest(five_points(), other));
    CHECK(takes_at_rest(five_points(), five_points()));
    SUBCASE("as many strokes")
    {
        other.strokes.push_back(row_of(1));
        CHECK_FALSE(takes_at_rest(five_points(), other));
        CHECK_FALSE(takes_at_rest(five_points(), {}));
    }
    SUBCASE("as many segments in each")
    {
        CHECK_FALSE(takes_at_rest(five_points(), {{row_of(2), row_of(3)}}));
        CHECK_FALSE(takes_at_rest(five_points(), {{row_of(3), row_of(3)}}));
    }
    SUBCASE("of the same kinds")
    {
        other.strokes[0].segments[1].cubic = true;
        CHECK_FALSE(takes_at_rest(five_points(), other));
        CHECK_FALSE(takes_at_rest(other, five_points()));
        CHECK(takes_at_rest(other, other));
    }
    SUBCASE("and it is there")
    {
        for (const std::uint32_t offset : {10'000U, 0xFFFFFFFEU})
            CHECK_FALSE(takes_skin(five_points(), skin_bytes({{5, {{0}}}}, offset + 1)));
    }
}

TEST_CASE("a bone may carry all points without a skin")
{
    for (const int bone : {0, 2, 3, 255}) {
        DeformedScene scene;
        scene.object =
            deformed_object(bytes({1}), {{.drawing = scene.drawings.add(five_points()), .more = -1 - bone}});
        CHECK(scene.is_taken() == (bone < 3));
    }
}

TEST_CASE("skins are there, as the skeletons that they bind to")
{
    const auto takes_number = [](int skeleton) {
        DeformedScene scene;
        const std::uint32_t drawing = scene.drawings.add(five_points());
        const std::uint32_t skin = scene.drawings.add(skin_bytes({{5, {{0}}}}));
        scene.object = deformed_object(bytes({skeleton}), bone_key(drawing, skin));
        return scene.is_taken();
    };
    CHECK(takes_number(1));
    CHECK_FALSE(takes_number(2));
    CHECK_FALSE(takes_number(255));
    DeformedScene scene;
    const std::uint32_t drawing = scene.drawings.add(five_points());
    const std::uint32_t skin = scene.drawings.add(skin_bytes({{5, {{0}}}}));
    for (const std::uint32_t offset : {skin + 100, 0x7FFFFFFFU, 0x80000000U}) {
        scene.object = deformed_object(bytes({1}), bone_key(drawing, offset));
        CHECK_FALSE(scene.is_taken());
    }
    scene.object = deformed_object(bytes({1}), {{.drawing = drawing}}); // no skin
    CHECK_FALSE(scene.is_taken());
}

TEST_CASE("what bones carry has no arrival drawings")
{
    constexpr int arrivals_bit = 0x40;
    DeformedScene scene;
    const std::uint32_t drawing = scene.drawings.add(five_points());
    const std::uint32_t skin = scene.drawings.add(skin_bytes({{5, {{0}}}}));
    const Bytes key = joined({bytes({0}), repeated(signed_varint(static_cast<std::int32_t>(drawing)), 2),
                              signed_varint(static_cast<std::int32_t>(skin))});
    scene.object = joined({bytes({0x88 | arrivals_bit, 1, 1}), key});
    CHECK_FALSE(scene.is_taken());
    scene.object = deformed_object(bytes({1}), bone_key(drawing, skin));
    CHECK(scene.is_taken());
}

TEST_CASE("backbones have three strokes of lines each, with as many points, at least two")
{
    CHECK(takes_form(backbones_of({2})));
    CHECK(takes_form(backbones_of({2, 5, 3})));
    CHECK_FALSE(takes_form({}));
    CHECK_FALSE(takes_form(backbones_of({1})));
    CHECK_FALSE(takes_form({{row_of(2), row_of(2)}}));
    CHECK_FALSE(takes_form({{row_of(2), row_of(2), row_of(2), row_of(2)}}));
    CHECK_FALSE(takes_form({{row_of(2), row_of(3), row_of(2)}}));
    CHECK_FALSE(takes_form({{row_of(2), row_of(2), row_of(3)}}));
    CHECK_FALSE(takes_form({{row_of(3), row_of(2), row_of(2)}}));
    for (std::size_t stroke = 0; stroke < 3; ++stroke) {
        scene::Drawing curved = backbones_of({3});
        curved.strokes[stroke].segments[1].cubic = true;
        CHECK_FALSE(takes_form(curved));
    }
}

TEST_CASE("there are at most 32 backbones with 255 segments together")
{
    CHECK(takes_form(backbones_of(std::vector<int>(32, 2))));
    CHECK_FALSE(takes_form(backbones_of(std::vector<int>(33, 2))));
    CHECK(takes_form(backbones_of({256})));
    CHECK_FALSE(takes_form(backbones_of({257})));
    CHECK(takes_form(backbones_of({101, 156})));
    CHECK_FALSE(takes_form(backbones_of({101, 157})));
}

TEST_CASE("backbones have the same form at all of their keys")
{
    const scene::Drawing first = backbones_of({3, 2});
    CHECK(takes_backbones(9, {{0, 1, first}, {3, 0, backbones_of({3, 2})}}));
    CHECK_FALSE(takes_backbones(9, {{0, 1, first}, {3, 0, backbones_of({2, 3})}}));
    CHECK_FALSE(takes_backbones(9, {{0, 1, first}, {3, 0, backbones_of({3})}}));
    CHECK_FALSE(takes_backbones(9, {{0, 1, first}, {3, 0, first}, {6, 0, backbones_of({3, 3})}}));
    CHECK_FALSE(takes_backbones(9, {{0, 1, first}, {3, 0, {}}}));
}

TEST_CASE("keys of backbones rise in time, have known laws and drawings that are there")
{
    const scene::Drawing form = backbones_of({2});
    CHECK(takes_backbones(9, {{0, 0, form}}));
    CHECK_FALSE(takes_backbones(9, {{0, 2, form}}));
    CHECK_FALSE(takes_backbones(9, {{2, 0, form}, {2, 0, form}}));
    CHECK(takes_backbones(9, {{kfb::max_time, 0, form}}));
    CHECK_FALSE(takes_backbones(9, {{kfb::max_time + 1024, 0, form}}));
    const auto takes_keys = [&form](const Bytes& keys) {
        DeformedScene scene;
        scene.drawings.add(form);
        scene.object = deformed_object(joined({bytes({0, 9}), keys}), {{}});
        return scene.is_taken();
    };
    CHECK(takes_keys(bytes({0, 0})));
    CHECK_FALSE(takes_keys(bytes({0, 200, 1})));
    CHECK_FALSE(takes_keys(bytes({0, 1})));
    CHECK_FALSE(takes_keys(bytes({0, 0xFF, 0xFF, 0xFF, 0xFF, 0x0F})));
}

TEST_CASE("a unit of backbones is 1 px to 2048 px")
{
    for (const int bits : {4, 15})
        CHECK(takes_backbones(bits, {{0, 0, backbones_of({2})}}));
    for (const int bits : {0, 3, 16, 255})
        CHECK_FALSE(takes_backbones(bits, {{0, 0, backbones_of({2})}}));
}

TEST_CASE("a scene says how many bones it has, and how many nodes and gaps any of its backbones")
{
    RawScene raw;
    raw.bones = joined({skeleton_bytes({{}, std::vector<RawBone>(3)}), //
                        skeleton_bytes({{}, std::vector<RawBone>(5)}), //
                        skeleton_bytes({{}, std::vector<RawBone>(2)})});
    RawDrawings drawings;
    const std::uint32_t small = drawings.add(backbones_of({2}));
    const std::uint32_t large = drawings.add(backbones_of({4, 3}));
    const auto object = [](std::uint32_t backbones) {
        return deformed_object(joined({bytes({0, 9}), key_bytes({{.drawing = backbones}})}), {{}});
    };
    raw.drawings = drawings.bytes();
    raw.items = joined({object(small), object(large), object(small)});
    const Bytes file = raw.file();
    const auto scene = SceneView::parse(file);
    REQUIRE(scene);
    CHECK(scene->bone_count() == 10);
    CHECK(scene->first_bone(0) == 0);
    CHECK(scene->first_bone(1) == 3);
    CHECK(scene->first_bone(2) == 8);
    CHECK(scene->backbone_nodes() == (4 + 1) + (3 + 1));
    CHECK(scene->camera() == 32);
}

TEST_CASE("there is an end to the skins that are read, one like that before aside")
{
    // 1023 points on a stroke that does not move
    const Bytes row = joined({bytes({1, 0, 0, 0, 1, 0xFC, 0x0F}), Bytes(256)});
    const auto takes_keys = [&row](int count, bool are_different) {
        DeformedScene scene;
        const std::uint32_t drawing = scene.drawings.add(row);
        const std::uint32_t first = scene.drawings.add(skin_bytes({{1023, {{0}}}}));
        const std::uint32_t second = scene.drawings.add(skin_bytes({{1023, {{1}}}}));
        std::vector<RawKey> keys;
        keys.reserve(static_cast<std::size_t>(count));
        for (int i = 0; i < count; ++i)
            keys.push_back({.time = Time{i},
                            .drawing = drawing,
                            .more = static_cast<std::int32_t>(are_different && i % 2 != 0 ? second : first)});
        scene.object = deformed_object(bytes({1}), keys);
        return scene.is_taken();
    };
    CHECK(takes_keys(250, true)); // 250 * (1 + 1023) = 256000
    CHECK_FALSE(takes_keys(270, true));
    CHECK(takes_keys(20'000, false));
}

TEST_CASE("there is an end to the drawings of backbones that are read")
{
    // 127 points on each of three strokes, which do not move
    const Bytes lines = joined({bytes({0, 0, 0, 1, 0xFC, 0x01}), Bytes(32)});
    const Bytes rows = joined({bytes({3}), repeated(lines, 3)});
    const auto takes_keys_of = [&rows](std::size_t count) {
        DeformedScene scene;
        scene.drawings.add(rows);
        std::vector<RawKey> backbones(count);
        for (std::size_t i = 0; i < count; ++i)
            backbones[i].time.ticks = static_cast<std::int32_t>(i);
        scene.object = deformed_object(joined({bytes({0, 4}), key_bytes(backbones)}), {{}});
        return scene.is_taken();
    };
    CHECK(takes_keys_of(670)); // 670 * (3 * 127 + 1) = 255940
    CHECK_FALSE(takes_keys_of(700));
}

}

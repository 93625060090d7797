#include "core/player.hpp"

#include "tests/core/moving_scenes.hpp"
#include "tests/core/player_fixture.hpp"

#include <doctest/doctest.h>

/// What bones and backbones carry must look like a drawing that is written where it comes to lie.
namespace kfast::test {
namespace {

using moving::line_to;
using moving::stroke_of;

constexpr Size canvas{60, 40};

Bytes picture_of(const RawScene& scene, Time time)
{
    return PlayerFixture{scene.file(), canvas}.picture(time);
}

/// Filled and stroked, without anything that carries it.
RawScene plain_scene(const scene::Drawing& drawing)
{
    RawScene scene = moving::empty_scene();
    scene.drawings = packed(drawing);
    scene.items = joined({bytes({0x18}), moving::style(), one_key()});
    return scene;
}

/// The drawing on one bone, which lies along x at (30, 20).
RawScene on_bone(const scene::Drawing& drawing, const RawBoneKeys& angle, const RawBoneKeys& x = {})
{
    RawScene scene = moving::empty_scene();
    RawDrawings drawings;
    const std::uint32_t at = drawings.add(drawing);
    const auto points = static_cast<std::uint32_t>(scene::point_count(drawing));
    const std::uint32_t skin = drawings.add(skin_bytes({{points, {{0}}}}));
    RawBone bone{.set_up = {0, 480, 320, 160}};
    bone.keys[0] = angle;
    bone.keys[1] = x;
    scene.bones = skeleton_bytes({{}, {bone}});
    scene.items = moving::deformed(bytes({1}), {moving::key_at(0, 0, at, skin)});
    scene.drawings = drawings.bytes();
    return scene;
}

const scene::Drawing flag{{stroke_of(30, 20, {line_to(45, 20), line_to(40, 28), line_to(30, 20)}),
                           stroke_of(20, 10, {line_to(28, 12)})}};

/// A quarter turn clockwise about (30, 20).
const scene::Drawing turned_flag{{stroke_of(30, 20, {line_to(30, 35), line_to(22, 30), line_to(30, 20)}),
                                  stroke_of(40, 10, {line_to(38, 18)})}};

/// Backbones from (10, 20) to (50, 20), in two segments with outlines 10 px away, and what they become.
struct Band {
    scene::Drawing form{{stroke_of(10, 20, {line_to(30, 20), line_to(50, 20)}),
                         stroke_of(10, 10, {line_to(30, 10), line_to(50, 10)}),
                         stroke_of(10, 30, {line_to(30, 30), line_to(50, 30)})}};
    /// 5 px lower, its outlines half as wide.
    scene::Drawing moved{{stroke_of(10, 25, {line_to(30, 25), line_to(50, 25)}),
                          stroke_of(10, 20, {line_to(30, 20), line_to(50, 20)}),
                          stroke_of(10, 30, {line_to(30, 30), line_to(50, 30)})}};
    /// In units of 16 px: from (20, 20) to (40, 10) and to (30, 25).
    scene::Drawing relative{{stroke_of(8, 0, {line_to(24, 16), line_to(16, -8), line_to(8, 0)})}};

    RawScene scene() const
    {
        RawScene raw = moving::empty_scene();
        RawDrawings drawings;
        const Bytes forms = key_bytes(
            {{.drawing = drawings.add(form)}, {.time = Time::frame(10), .drawing = drawings.add(moved)}});
        raw.items = moving::deformed(joined({bytes({0, 8}), forms}), {{.drawing = drawings.add(relative)}});
        raw.drawings = drawings.bytes();
        return raw;
    }
};

}

TEST_CASE("a drawing on a bone is as drawn while the bone is as set up, and turns with it")
{
    const RawScene scene =
        on_bone(flag, {.common = {}, .own = {{Time::frame(4), 0, 0}, {Time::frame(6), 0, 32767}}});
    CHECK(picture_of(scene, {}) == picture_of(plain_scene(flag), {}));
    CHECK(picture_of(scene, Time::frame(4)) == picture_of(plain_scene(flag), {}));
    const RawScene turned = on_bone(flag, {.common = {}, .own = {{{}, 0, 16384}}});
    CHECK(picture_of(turned, {}) == picture_of(plain_scene(turned_flag), {}));
}

TEST_CASE("the skin of a drawing with another at rest moves it as that would")
{
    const scene::Drawing elsewhere{{stroke_of(32, 23, {line_to(45, 15), line_to(41, 30), line_to(32, 23)}),
                                    stroke_of(18, 10, {line_to(28, 13)})}};
    // A quarter turn moves each point of the flag by so much; those of the other drawing move as far.
    const scene::Drawing expected{{stroke_of(32, 23, {line_to(30, 30), line_to(23, 32), line_to(32, 23)}),
                                   stroke_of(38, 10, {line_to(38, 19)})}};
    RawScene scene = on_bone(flag, {.common = {}, .own = {{{}, 0, 16384}}});
    RawDrawings drawings;
    const std::uint32_t rest = drawings.add(flag);
    const std::uint32_t own = drawings.add(elsewhere);
    const std::uint32_t skin = drawings.add(skin_bytes({{6, {{0}}}}, rest + 1));
    scene.items = moving::deformed(bytes({1}), {moving::key_at(0, 0, own, skin)});
    scene.drawings = drawings.bytes();
    CHECK(picture_of(scene, {}) == picture_of(plain_scene(expected), {}));
}

TEST_CASE("between two keys each drawing is carried by itself, then tweened")
{
    RawScene scene = on_bone(flag, {}, {.common = {}, .own = {{{}, 0, 480}, {Time::frame(10), 0, 320}}});
    RawDrawings drawings;
    const std::uint32_t first = drawings.add(flag);
    const std::uint32_t second = drawings.add(turned_flag);
    const std::uint32_t skin = drawings.add(skin_bytes({{6, {{0}}}}));
    scene.items = moving::deformed(bytes({1}),
                                   {moving::key_at(0, 0, first, skin), moving::key_at(10, 0, second, skin)});
    scene.drawings = drawings.bytes();
    // Half of the way, 5 px to the left.
    const scene::Drawing half{
        {stroke_of(
             25, 20,
             {{.cubic = false, .c1 = {}, .c2 = {}, .to = {520, 440}}, line_to(26, 29), line_to(25, 20)}),
         stroke_of(25, 10, {line_to(28, 15)})}};
    CHECK(picture_of(scene, Time::frame(5)) == picture_of(plain_scene(half), {}));
}

TEST_CASE("a drawing in relative coordinates goes with its backbone and its outlines")
{
    const RawScene scene = Band{}.scene();
    const scene::Drawing at_first{{stroke_of(20, 20, {line_to(40, 10), line_to(30, 25), line_to(20, 20)})}};
    const scene::Drawing at_last{{stroke_of(
        20, 25, {line_to(40, 20), {.cubic = false, .c1 = {}, .c2 = {}, .to = {480, 440}}, line_to(20, 25)})}};
    const scene::Drawing half{{{.from = {320, 360},
                                .segments = {line_to(40, 15),
                                             {.cubic = false, .c1 = {}, .c2 = {}, .to = {480, 420}},
                                             {.cubic = false, .c1 = {}, .c2 = {}, .to = {320, 360}}}}}};
    CHECK(picture_of(scene, {}) == picture_of(plain_scene(at_first), {}));
    CHECK(picture_of(scene, Time::frame(5)) == picture_of(plain_scene(half), {}));
    CHECK(picture_of(scene, Time::frame(10)) == picture_of(plain_scene(at_last), {}));
    CHECK(picture_of(scene, Time::frame(20)) == picture_of(plain_scene(at_last), {}));
}

TEST_CASE("a way leads to its arrival drawing, and the next one begins with the drawing of its key")
{
    Band band;
    RawScene scene = moving::empty_scene();
    RawDrawings drawings;
    const Bytes forms = key_bytes({{.drawing = drawings.add(band.form)}});
    const std::uint32_t own = drawings.add(band.relative);
    const std::uint32_t arrival =
        drawings.add({{stroke_of(16, 0, {line_to(24, 0), line_to(16, -8), line_to(16, 0)})}});
    scene.items =
        moving::deformed(joined({bytes({0, 8}), forms}),
                         {moving::key_at(0, 0, own, arrival), moving::key_at(4, 0, own, own)}, 0x40);
    scene.drawings = drawings.bytes();
    const scene::Drawing half{{stroke_of(25, 20, {line_to(40, 15), line_to(30, 25), line_to(25, 20)})}};
    CHECK(picture_of(scene, Time::frame(2)) == picture_of(plain_scene(half), {}));
    CHECK(picture_of(scene, {}) == picture_of(scene, Time::frame(4)));
}

}

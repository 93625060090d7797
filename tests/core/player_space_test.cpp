#include "core/player.hpp"

#include "tests/core/moving_scenes.hpp"
#include "tests/core/player_fixture.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <random>

/// What turns in space must look like a drawing that is written where it is seen.
namespace kfast::test {
namespace {

using moving::line_to;
using moving::stroke_of;

constexpr Size canvas{60, 40};

const scene::Drawing flag{{stroke_of(32, 22, {line_to(42, 22), line_to(38, 28), line_to(32, 22)}),
                           stroke_of(20, 14, {line_to(28, 16)})}};

/// Filled and stroked, with `count` tracks, in a scene whose camera is 40 px away.
RawScene tracked_scene(const scene::Drawing& drawing, int count, const Bytes& tracks)
{
    RawScene scene = moving::empty_scene();
    scene.camera = 40;
    scene.drawings = packed(drawing);
    scene.items =
        joined({count == 0 ? bytes({0x18}) : bytes({0x1C, count}), tracks, moving::style(), one_key()});
    return scene;
}

Bytes picture_of(const scene::Drawing& drawing, int count, const Bytes& tracks, Size panel = canvas)
{
    return PlayerFixture{tracked_scene(drawing, count, tracks).file(), panel}.picture({});
}

}

TEST_CASE("at half the distance of the camera all is seen twice as large, widths too")
{
    const Bytes nearer = fixed_track(Property::z, 16 * 20);
    const Bytes larger = joined({fixed_track(Property::scale_x, 8192), fixed_track(Property::scale_y, 8192),
                                 fixed_track(Property::pivot_x, 480), fixed_track(Property::pivot_y, 320)});
    for (const Size panel : {canvas, Size{120, 80}, Size{60, 60}})
        CHECK(picture_of(flag, 1, nearer, panel) == picture_of(flag, 4, larger, panel));
    CHECK(picture_of(flag, 1, nearer) != picture_of(flag, 0, {}));
}

TEST_CASE("half a turn about an axis of the canvas mirrors")
{
    const Bytes pivot = joined({fixed_track(Property::pivot_x, 480), fixed_track(Property::pivot_y, 320)});
    CHECK(picture_of(flag, 3, joined({fixed_track(Property::rotation_y, 32768), pivot})) ==
          picture_of(flag, 3, joined({fixed_track(Property::scale_x, -4096), pivot})));
    CHECK(picture_of(flag, 3, joined({fixed_track(Property::rotation_x, -32768), pivot})) ==
          picture_of(flag, 3, joined({fixed_track(Property::scale_y, -4096), pivot})));
}

TEST_CASE("what is seen from its edge leaves no fill")
{
    RawScene scene = tracked_scene(flag, 0, {});
    scene.items = joined({bytes({0x0C, 3}), fixed_track(Property::rotation_y, 16384),
                          fixed_track(Property::pivot_x, 480), fixed_track(Property::pivot_y, 320),
                          bytes({1}), one_key()});
    RawScene nothing_there = moving::empty_scene();
    nothing_there.items = {};
    CHECK(PlayerFixture{scene.file(), canvas}.picture({}) ==
          PlayerFixture{nothing_there.file(), canvas}.picture({}));
}

TEST_CASE("groups turn in one space with what they hold")
{
    // moved towards the viewer inside of a group that turns it away to the right
    const Bytes inner = joined({bytes({0x1C, 1}), fixed_track(Property::z, 160), moving::style(), one_key()});
    RawScene nested = tracked_scene(flag, 0, {});
    nested.items =
        joined({bytes({0x05, 1}), fixed_track(Property::rotation_y, 16384),
                block(joined({bytes({0x05, 1}), fixed_track(Property::rotation_y, -16384), block(inner)}))});
    CHECK(PlayerFixture{nested.file(), canvas}.picture({}) ==
          picture_of(flag, 1, fixed_track(Property::z, 160)));
    // turned by a quarter, what lay 10 px nearer lies 10 px to the right
    nested.items =
        joined({bytes({0x05, 1}), fixed_track(Property::rotation_y, 16384),
                block(joined({bytes({0x1C, 2}), fixed_track(Property::z, 160),
                              fixed_track(Property::rotation_y, -16384), moving::style(), one_key()}))});
    CHECK(PlayerFixture{nested.file(), canvas}.picture({}) ==
          picture_of(flag, 1, fixed_track(Property::x, 160)));
}

TEST_CASE("curves are projected piece by piece: a circle that is tilted stays symmetrical")
{
    const scene::Drawing round{
        {stroke_of(20, 20,
                   {moving::curve_to(20, 14, 24, 10, 30, 10), moving::curve_to(36, 10, 40, 14, 40, 20),
                    moving::curve_to(40, 26, 36, 30, 30, 30), moving::curve_to(24, 30, 20, 26, 20, 20)})}};
    const Bytes tilted = joined({fixed_track(Property::rotation_x, 9000), fixed_track(Property::pivot_x, 480),
                                 fixed_track(Property::pivot_y, 320)});
    PlayerFixture fixture{tracked_scene(round, 3, tilted).file(), canvas};
    const Bytes grey = fixture.picture<PixelFormat::grey4>({});
    for (int row = 0; row < 40; ++row) {
        const auto begin = grey.begin() + row * 30;
        const std::string text = row_text({begin, begin + 30});
        const std::string mirrored{text.rbegin(), text.rend()};
        CHECK(text == mirrored);
    }
}

}

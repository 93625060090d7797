#pragma once

#include "tests/core/raw_bones.hpp"
#include "tests/core/raw_drawing.hpp"
#include "tests/core/raw_scene.hpp"
#include "tests/core/raw_skin.hpp"

#include <cstdint>
#include <vector>

/// Scenes of 60 x 40 px and 30 frames in which bones, backbones, paths and turns in space move all there is,
/// put together by hand. Their outlines have room.
namespace kfast::test {

namespace moving {

constexpr int accelerate_decelerate = 1; ///< accelerate for x, decelerate for y
constexpr int easing = 2;                ///< accelerate-decelerate for x, steps for y
constexpr int wild = 3;                  ///< both swing far beyond their ends

inline RawScene empty_scene()
{
    RawScene scene;
    scene.outline_bytes = 400'000;
    scene.cache_bytes = 2'000;
    scene.ticks = 30 * 1024;
    scene.width = 60;
    scene.height = 40;
    scene.camera = 50;
    scene.law_count = 3;
    scene.laws = bytes({0x21,                                              //
                        0x53, 7, 0,                                        //
                        0x66, 0, 0,    0x00, 0xC0, 0,    0x20, 0x00, 0x60, // y from -2 to 3
                        0,    0, 0x00, 0xC0, 0,    0x20, 0x00, 0x60});
    return scene;
}

inline scene::Segment line_to(int x, int y)
{
    return {.cubic = false,
            .c1 = {},
            .c2 = {},
            .to = {static_cast<std::int16_t>(x * 16), static_cast<std::int16_t>(y * 16)}};
}

inline scene::Segment curve_to(int x1, int y1, int x2, int y2, int x, int y)
{
    return {.cubic = true, .c1 = line_to(x1, y1).to, .c2 = line_to(x2, y2).to, .to = line_to(x, y).to};
}

inline scene::Stroke stroke_of(int x, int y, std::vector<scene::Segment> segments)
{
    return {.from = line_to(x, y).to, .segments = std::move(segments)};
}

/// Closed, of three segments, and open, of two: nine points.
inline scene::Drawing leaf()
{
    return {{stroke_of(20, 30,
                       {curve_to(10, 20, 20, 10, 30, 8), line_to(40, 20), curve_to(40, 30, 30, 36, 20, 30)}),
             stroke_of(12, 12, {line_to(30, 20), curve_to(35, 25, 50, 10, 55, 30)})}};
}

/// Built alike, elsewhere.
inline scene::Drawing other_leaf()
{
    return {{stroke_of(25, 25,
                       {curve_to(5, 25, 15, 5, 35, 12), line_to(45, 28), curve_to(35, 38, 28, 30, 25, 25)}),
             stroke_of(5, 35, {line_to(20, 14), curve_to(30, 5, 40, 38, 50, 12)})}};
}

/// A single stroke of one curve and two lines.
inline scene::Drawing hook()
{
    return {{stroke_of(30, 30, {curve_to(30, 15, 45, 15, 45, 22), line_to(40, 26), line_to(30, 30)})}};
}

/// Filled white and stroked half red, 3 px wide, round; behind its head and tracks.
inline Bytes style() { return bytes({1, 2, 48, 5}); }

/// An object without tracks, `deformer` and all, with the keys.
inline Bytes deformed(const Bytes& deformer, const std::vector<RawKey>& keys, int more_bits = 0)
{
    return joined({bytes({0x98 | more_bits}), style(), deformer, key_bytes(keys)});
}

/// Filled and stroked, and the tracks with their number; a leaf that becomes another.
inline Bytes tracked_leaf(const Bytes& count_and_tracks, std::uint32_t leaf, std::uint32_t other)
{
    const Bytes keys = key_bytes({{{}, wild, leaf}, {Time::frame(30), 0, other}});
    return joined({bytes({0x1C}), count_and_tracks, style(), keys});
}

/// Of an object, with its arrival drawing or its skin.
inline RawKey key_at(int frame, int laws, std::uint32_t drawing, std::uint32_t more)
{
    return {Time::frame(frame), laws, drawing, static_cast<std::int32_t>(more)};
}

inline RawSkeleton puppet()
{
    RawBone torso{.set_up = {49152, 30 * 16, 36 * 16, 16 * 16}};
    torso.keys[0].common = {49152, 40000, 60000, 49152};
    torso.keys[1].common = {480, 400, 560, 480};
    torso.keys[3].common = {256, 300, 180, 256};
    RawBone arm{.parent = 1, .is_at_tip = true, .set_up = {10000, 256, 0, 160}};
    arm.keys[0].common = {10000, 20000, 52768, 10000}; // half a turn on the way
    arm.keys[2].own = {{Time::frame(5), easing, 0}, {Time::frame(25), 0, 60}};
    RawBone hand{.parent = 2, .is_at_tip = true, .turns_as_written = true, .set_up = {5000, 160, 0, 90}};
    hand.keys[0].own = {{{}, easing, 5000}, {Time::frame(22), wild, -150'000}, {Time::frame(30), 0, 5000}};
    hand.keys[3].own = {{{}, wild, 90}, {Time::frame(30), 0, 0}};
    RawBone tail{.set_up = {20000, 20 * 16, 30 * 16, 320}};
    tail.keys[0].common = {20000, 0, 30000, 20000};
    return {
        {{{}, accelerate_decelerate}, {Time::frame(10), easing}, {Time::frame(20), wild}, {Time::frame(30)}},
        {torso, arm, hand, tail}};
}

}

/// Skins of one bone and of four, a drawing at rest, drawings of other forms, and the empty one.
inline RawScene bones_scene()
{
    using namespace moving;
    RawScene scene = empty_scene();
    RawDrawings drawings;
    const std::uint32_t leaf_at = drawings.add(leaf());
    const std::uint32_t other_at = drawings.add(other_leaf());
    const std::uint32_t hook_at = drawings.add(hook());
    const std::uint32_t empty_at = drawings.add(scene::Drawing{});
    const std::vector<RawRun> mixed{{3, {{0, 25'600}, {1, 39'936}}},
                                    {1, {{2}}},
                                    {2, {{0, 16'384}, {1, 16'384}, {2, 16'384}, {3, 16'384}}},
                                    {1, {{1, 300}, {3, 65'236}}}};
    const std::uint32_t mixed_at = drawings.add(skin_bytes(mixed));
    const std::uint32_t rest_at = drawings.add(skin_bytes(mixed, leaf_at + 1));
    const std::uint32_t hook_skin = drawings.add(skin_bytes({{4, {{1}}}}));
    const std::uint32_t no_skin = drawings.add(skin_bytes({}));
    scene.bones = joined({skeleton_bytes({{}, {{.set_up = {0, 0, 0, 160}}}}), skeleton_bytes(puppet())});
    scene.items = joined(
        {deformed(bytes({2}),
                  {key_at(0, easing, leaf_at, mixed_at), key_at(8, wild, hook_at, hook_skin),
                   key_at(16, accelerate_decelerate, other_at, rest_at), key_at(24, 0, empty_at, no_skin)}),
         deformed(bytes({1}), {{.drawing = hook_at, .more = -1}})});
    scene.drawings = drawings.bytes();
    return scene;
}

/// Two backbones in three keys; a drawing in relative coordinates, with arrival drawings.
inline RawScene backbones_scene()
{
    using namespace moving;
    RawScene scene = empty_scene();
    RawDrawings drawings;
    const auto form = [&drawings](int bend) {
        return drawings.add(
            scene::Drawing{{stroke_of(10, 20, {line_to(25, 20 + bend), line_to(40, 20)}),
                            stroke_of(10, 10, {line_to(25, 8 + bend), line_to(40, 12)}),
                            stroke_of(10, 28, {line_to(25, 30 + bend), line_to(45, 30)}),
                            stroke_of(50, 5, {line_to(52 - bend, 35)}), stroke_of(58, 5, {line_to(58, 35)}),
                            stroke_of(44, 5, {line_to(44 - bend, 35)})}});
    };
    // In units of 16 px: 2 segments, a gap of 2, 1 segment.
    const scene::Drawing round{
        {stroke_of(-10, 0,
                   {curve_to(0, 30, 20, 16, 32, 8), line_to(40, -8), curve_to(20, -20, 0, -12, -10, 0)}),
         stroke_of(64, 10, {line_to(80, -10)})}};
    const scene::Drawing away{
        {stroke_of(0, 4, {curve_to(64, 8, 70, -8, 66, 8), line_to(30, -20), curve_to(10, -2, 5, -9, 0, 4)}),
         stroke_of(8, 10, {line_to(78, 25)})}};
    const std::uint32_t round_at = drawings.add(round);
    const std::uint32_t away_at = drawings.add(away);
    const Bytes forms = key_bytes({{{}, easing, form(0)},
                                   {Time::frame(12), wild, form(9)},
                                   {Time::frame(28), accelerate_decelerate, form(-8)}});
    scene.items = deformed(joined({bytes({0, 8}), forms}),
                           {key_at(0, accelerate_decelerate, round_at, away_at),
                            key_at(14, wild, away_at, round_at), key_at(26, 0, round_at, round_at)},
                           0x40);
    scene.drawings = drawings.bytes();
    return scene;
}

/// Groups that turn in space around a symbol and objects, some of them transparent.
inline RawScene space_scene()
{
    using namespace moving;
    RawScene scene = empty_scene();
    RawDrawings drawings;
    const std::uint32_t leaf_at = drawings.add(leaf());
    const std::uint32_t other_at = drawings.add(other_leaf());
    const Bytes plain =
        tracked_leaf(joined({bytes({1}), fixed_track(Property::opacity, 200)}), leaf_at, other_at);
    scene.add_symbol(plain);
    const Bytes turned = joined(
        {smooth_track(Property::z, {{{}, 0, -400}, {Time::frame(15), 0, 700}, {Time::frame(28), 0, 0}}),
         moving_track(Property::rotation_y, {{{}, wild, 0}, {Time::frame(30), 0, 131'072}}),
         fixed_track(Property::pivot_x, 480), fixed_track(Property::pivot_y, 320)});
    const Bytes used =
        joined({bytes({0x06, 2}),
                smooth_track(Property::rotation_x,
                             {{{}, 0, 0}, {Time::frame(9), 0, 9000}, {Time::frame(30), 0, -70'000}}),
                fixed_track(Property::scale_x, -3000), bytes({0})});
    const Bytes inner = joined(
        {bytes({0x05, 2}), fixed_track(Property::rotation_x, 4000),
         smooth_track(Property::opacity, {{{}, 0, 255}, {Time::frame(20), 0, 0}, {Time::frame(30), 0, 255}}),
         block(joined({used, tracked_leaf(joined({bytes({4}), turned}), other_at, leaf_at)}))});
    scene.items = joined(
        {bytes({0x05, 4}), turned, block(inner),
         tracked_leaf(joined({bytes({1}),
                              moving_track(Property::z, {{{}, easing, 2000}, {Time::frame(30), 0, -9000}})}),
                      leaf_at, leaf_at)});
    scene.drawings = drawings.bytes();
    return scene;
}

/// A group and an object that follow paths, one turning with it, out of the plane.
inline RawScene path_scene()
{
    using namespace moving;
    RawScene scene = empty_scene();
    RawDrawings drawings;
    const std::uint32_t leaf_at = drawings.add(leaf());
    const std::uint32_t hook_at = drawings.add(hook());
    const std::uint32_t track_at = drawings.add({{stroke_of(
        0, 0, {curve_to(20, -20, 30, 30, 40, 0), line_to(40, -20), curve_to(0, -20, -20, 0, 0, 0)})}});
    const Bytes path = path_bytes(true, track_at, {700, 320, 900});
    const Bytes smooth = smooth_track(
        Property::along, {{{}, 0, 0}, {Time::frame(10), 0, 50'000}, {Time::frame(30), 0, 65536}});
    const Bytes swinging = moving_track(
        Property::along, {{{}, wild, 0}, {Time::frame(20), easing, 65536}, {Time::frame(30), 0, 9000}});
    const Bytes inner = joined({bytes({2}), fixed_track(Property::rotation_y, 5000), swinging,
                                path_bytes(false, track_at, {1, 1, 1})});
    scene.items =
        joined({bytes({0x05, 3}), fixed_track(Property::pivot_x, 480), fixed_track(Property::pivot_y, 320),
                smooth, path, block(tracked_leaf(inner, leaf_at, hook_at))});
    scene.drawings = drawings.bytes();
    return scene;
}

inline std::vector<RawScene> moving_scenes()
{
    return {bones_scene(), backbones_scene(), space_scene(), path_scene()};
}

}

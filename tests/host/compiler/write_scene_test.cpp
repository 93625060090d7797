#include "host/compiler/write_scene.hpp"

#include "core/bytes/crc32.hpp"
#include "core/scene/scene_view.hpp"
#include "tests/bytes.hpp"
#include "tests/host/compiler/scene_parts.hpp"

#include <doctest/doctest.h>
#include <span>

namespace kfast::test {
namespace {

using Bytes = std::vector<std::byte>;

Bytes behind(const Bytes& bytes, std::size_t offset)
{
    return {bytes.begin() + static_cast<std::ptrdiff_t>(offset), bytes.end()};
}

/// Behind the checksum, the size and what outlines need.
Bytes rest_of(const Bytes& file)
{
    ByteReader reader{std::span{file}.subspan(8)};
    for (int skipped = 0; skipped < 4; ++skipped)
        reader.varint();
    return {reader.rest().begin(), reader.rest().end()};
}

/// Of scene_of(), with two opaque colours.
constexpr std::size_t header_and_palette = 7 + 1 + 2 * 3;

std::size_t size_of(std::vector<scene::Item> items)
{
    return rest_of(written(scene_of(std::move(items)))).size();
}

}

TEST_CASE("a small scene, byte by byte")
{
    scene::Scene scene = scene_of({item(filled({key(0, lines({{16, 32}, {32, 32}, {16, 32}}))}))});
    std::get<scene::Object>(scene.items[0].content).fill = 1;
    scene.frame_rate = 25'000;
    scene.loop = Loop::ping_pong;
    scene.palette = {{0x10, 0x20, 0x30}, {0x4c, 0xc9, 0xf0, 0x80}};
    const Bytes all = written(scene);
    CHECK(Bytes{all.begin(), all.begin() + 4} == bytes({'K', 'F', 'B', 3}));
    constexpr std::size_t size_at = 8;
    Crc32 checksum;
    checksum.add(behind(all, size_at));
    CHECK(ByteReader{std::span{all}.subspan(4)}.u32() == checksum.value());
    ByteReader sized{std::span{all}.subspan(size_at)};
    const std::size_t size = sized.varint();
    CHECK(size == sized.left());
    CHECK(rest_of(all) ==
          bytes({
              0x0E, 80,   50,   64,   48,   0xE0, 3, // ping-pong, 40 frames, 25 a second, camera
              2,    0x10, 0x20, 0x30, 0xFF, 0x4C, 0xC9, 0xF0, 0x80, // palette
              0,                                                    // laws
              4,    0x08, 1,    0,    0,                            // filled, colour, one key
              1,    32,   64,   0x14, 6,    4,    0x90,             // closed and sparse, 6 bits: 16
          }));
}

TEST_CASE("laws, marks, symbols, groups, uses, tracks and styles, byte by byte")
{
    const LawPair soft{VelocityLaw::accelerate, VelocityLaw::decelerate};
    const LawPair wild{VelocityLaw::in_steps(3), VelocityLaw::bezier(2048, -8192, 6144, 16384)};
    scene::Object wheel = stroked(40, {key(0, {{{.from = {10, 11}, .segments = {}}}})});
    wheel.stroke->colour = 1;
    wheel.stroke->cap = Cap::round;
    scene::Object spot = filled({key(0, lines({{0, 0}, {1, 0}}), wild), key(1, {})});
    spot.keys[1].time = {1};
    spot.fill_rule = FillRule::even_odd;
    const scene::Item use = item(scene::Use{0}, {fixed(Property::scale_x, -8192)});
    const scene::Track fade{
        Property::opacity,
        {{.time = {}, .laws = soft, .value = 255}, {.time = Time::frame(10), .laws = wild, .value = 0}}};
    const scene::Item group = item(scene::Group{{use}}, {fixed(Property::rotation, 16384), fade});
    scene::Scene scene = scene_of({group, item(spot)}, {{"wheel", {item(wheel)}}});
    scene.clocks = {{.delay = Time::frame(2)}};
    scene.clips = {{"go", Time::frame(10), {10 * 1024 + 5632}, Loop::repeat}};
    scene.events = {{"a", Time::frame(3)}, {"é", Time::frame(3)}};

    const Bytes all = written(scene);
    CHECK(behind(rest_of(all), header_and_palette) ==
          bytes({
              2,    0x21,                                                    // accelerate, decelerate
              0x65, 3,    0,    0x00, 0x08, 0x00, 0xE0, 0x00, 0x18, 0, 0x40, // steps, bezier
              24,   1,    0,    0,    0x80, 0x20, 0x80, 0x80, 8,    0, // marks: one clock, 2 frames late
              1,                                                       // one clip
              2,    'g',  'o',  20,   0x81, 0x58, 1,                   // from frame 10, 5632 ticks long
              6,    1,    'a',  0,    2,    0xC3, 0xA9,                // events
              1,    8,    7,                                           // one symbol
              0x10, 1,    40,   1,    32,   0,    0,                   //
              31,                                                      // items
              0x05, 2,    0x85, 0x80, 0x80, 2,                         // group: a quarter turn,
              11,   2,    0x63, 3,    0x1A, 8,    0,    0xFF, 0,       // opacity from 255 to 0
              6,    0x06, 1,    0x86, 0xFF, 0x7F, 0,                   // the use, mirrored
              0x28, 0,    2,    1,    4,    0x50, 3,    12,   0x1C,    // even-odd; 1 tick to the second key
              1,    20,   22,   0,    1,    0,                         // the single point
              1,    0,    0,    0,    2,    2,    0x40,                // the line
              0,                                                       // the empty drawing
          }));
}

TEST_CASE("tracks that change nothing are left out")
{
    const auto dot = filled({key(0, lines({{0, 0}, {16, 0}}))});
    const auto wire = stroked(16, {key(0, lines({{0, 0}, {16, 0}}))});
    const std::size_t plain = size_of({item(dot)});
    const auto growth = [&](const scene::Object& object, std::vector<scene::Track> tracks) {
        return size_of({item(object, std::move(tracks))}) - size_of({item(object)});
    };
    const scene::Track turning{
        Property::rotation,
        {{.time = {}, .laws = {}, .value = 0}, {.time = Time::frame(1), .laws = {}, .value = 0}}};
    CHECK(plain > 0);
    CHECK(growth(dot, {fixed(Property::x, 0), fixed(Property::rotation, 0), fixed(Property::scale_x, 4096),
                       fixed(Property::scale_y, 4096), fixed(Property::opacity, 255),
                       fixed(Property::order, 0), fixed(Property::visible, 1), fixed(Property::fill, 0)}) ==
          0);
    CHECK(growth(wire, {fixed(Property::stroke, 0), fixed(Property::width, 16)}) == 0);
    CHECK(growth(dot, {fixed(Property::x, 1)}) == 3);
    CHECK(growth(dot, {fixed(Property::fill, 1)}) == 3);
    CHECK(growth(wire, {fixed(Property::width, 17)}) == 3);
    CHECK(growth(dot, {fixed(Property::opacity, 0)}) == 3);
    CHECK(growth(dot, {turning}) == 8); // it has keys
    const auto beam_bytes = [&](const BeamStyle& style) {
        scene::Object drawn = dot;
        drawn.beam = style;
        return size_of({item(drawn)}) - plain;
    };
    CHECK(beam_bytes({}) == 0);
    CHECK(beam_bytes({.parts = BeamParts::none}) == 2);
    CHECK(beam_bytes({.parts = BeamParts::hatch}) == 4);
    SUBCASE("a pivot counts only where something turns or grows")
    {
        const scene::Track pivot_x = fixed(Property::pivot_x, 5);
        const scene::Track pivot_y = fixed(Property::pivot_y, 5);
        CHECK(growth(dot, {fixed(Property::x, 1), pivot_x, pivot_y}) == 3);
        CHECK(growth(dot, {fixed(Property::rotation, 0), pivot_x}) == 0);
        CHECK(growth(dot, {fixed(Property::rotation, 1), pivot_x}) == 5);
        CHECK(growth(dot, {fixed(Property::scale_y, 1), pivot_x, pivot_y}) == 7);
        CHECK(growth(dot, {fixed(Property::scale_x, 1), pivot_y}) == 5);
    }
}

TEST_CASE("a smooth track has no laws")
{
    const auto dot = filled({key(0, lines({{0, 0}, {16, 0}}))});
    const auto growth = [&dot](const std::vector<int>& values) {
        scene::Track track{Property::z, {}, true};
        for (const int value : values)
            track.keys.push_back(
                {.time = Time::frame(static_cast<int>(track.keys.size())), .laws = {}, .value = value});
        return behind(rest_of(written(scene_of({item(dot, {track})}))), header_and_palette + 2);
    };
    const auto head = [](const Bytes& all, std::size_t count) {
        return Bytes{all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)};
    };
    CHECK(head(growth({3, 3}), 9) == bytes({0x0C, 1, 0x42, 2, 0x41, 1, 0x40, 0, 6}));
    CHECK(head(growth({3}), 4) == bytes({0x0C, 1, 0x82, 6})); // fixed
    CHECK(head(growth({0}), 1) == bytes({0x08}));             // the ordinary value
}

TEST_CASE("a path follows the tracks, with the lengths of its segments")
{
    const auto dot = filled({key(0, lines({{0, 0}, {16, 0}}))});
    const scene::Stroke corner = lines({{0, 0}, {16, 0}, {16, 3200}}).strokes.front();
    const auto followed = [&](const scene::Path& path, std::size_t count) {
        scene::Item follower = item(dot, {fixed(Property::along, 0)});
        follower.path = path;
        const Bytes all = behind(rest_of(written(scene_of({follower}))), header_and_palette + 2);
        return Bytes{all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)};
    };
    CHECK(followed({corner, true}, 10) == bytes({0x0C, 1, 0x8A, 0, 5, 1, 0, 16, 0x80, 25}));
    CHECK(followed({corner, false}, 6) == bytes({0x0C, 1, 0x8A, 0, 5, 0}));
    const scene::Stroke tick = curve({0, 0}, {1, 0}, {0, 0}, {0, 0}).strokes.front();
    CHECK(followed({tick, false}, 8) == bytes({0x0C, 1, 0x8A, 0, 3, 0, 0, 1}));
}

TEST_CASE("a path is as long as the format allows")
{
    scene::Stroke zigzag{{-32000, 0}, {}};
    for (int i = 0; i < 150; ++i)
        zigzag.segments.push_back({.cubic = false,
                                   .c1 = {},
                                   .c2 = {},
                                   .to = {static_cast<std::int16_t>(i % 2 == 0 ? 32000 : -32000), 0}});
    scene::Item follower = item(scene::Group{}, {fixed(Property::along, 0)});
    follower.path = scene::Path{zigzag, false};
    follower.place = {3, 2};
    Diagnostics diagnostics;
    CHECK(!write_scene(scene_of({follower}), diagnostics));
    REQUIRE(diagnostics.sorted().size() == 1);
    CHECK(diagnostics.sorted().front().place.offset == 3);
    CHECK(diagnostics.sorted().front().message == "the path of this item is too long for the format");
}

TEST_CASE("a drawing is stored once, whoever shows it")
{
    const scene::Drawing shape = curve({0, 0}, {900, 0}, {0, 900}, {900, 900});
    const auto shown = [&shape](int frame) { return key(frame, shape); };
    const std::size_t once = size_of({item(filled({shown(0)}))});
    CHECK(size_of({item(filled({shown(0), shown(1)}))}) == once + 4); // it has key times
    CHECK(size_of({item(filled({shown(0)})), item(filled({shown(0)}))}) == once + 4);
    const scene::Scene with_symbol =
        scene_of({item(filled({shown(0)})), item(scene::Use{0})}, {{"again", {item(filled({shown(0)}))}}});
    CHECK(rest_of(written(with_symbol)).size() ==
          once + 3 + 4 + 2); // number and lengths, the object, the use
}

TEST_CASE("keys that match by length have arrival drawings, the others of the object too")
{
    const scene::Drawing square = lines({{0, 0}, {160, 0}, {160, 160}, {0, 160}, {0, 0}});
    const scene::Drawing triangle = lines({{400, 0}, {560, 160}, {240, 160}, {400, 0}});
    scene::Object object = filled({key(0, square), key(1, triangle), key(2, square)});
    const auto keys_of = [](const Bytes& bytes) {
        const ObjectView view = SceneView::parse(bytes)->items().next().object;
        KeyCursor keys = view.keys();
        return std::vector{keys.next(), keys.next(), keys.next()};
    };
    SUBCASE("none")
    {
        object.keys[2].match = scene::Match::length; // leads nowhere
        const Bytes bytes = written(scene_of({item(object)}));
        CHECK(!SceneView::parse(bytes)->items().next().object.has_arrivals);
    }
    SUBCASE("one")
    {
        object.keys[1].match = scene::Match::length;
        const Bytes bytes = written(scene_of({item(object)}));
        const SceneView scene = *SceneView::parse(bytes);
        REQUIRE(scene.items().next().object.has_arrivals);
        const std::vector<Key> keys = keys_of(bytes);
        CHECK(keys[0].arrival != keys[0].drawing);
        CHECK(keys[1].arrival != keys[1].drawing);
        CHECK(keys[2].arrival == keys[2].drawing);
        CHECK(keys[0].drawing == keys[2].drawing);
        PackedDrawing departure = scene.drawing(keys[1].drawing);
        PackedDrawing arrival = scene.drawing(keys[1].arrival);
        CHECK(scene.drawing(keys[0].arrival).next_stroke() == 3);
        CHECK(departure.next_stroke() == arrival.next_stroke());
    }
}

}

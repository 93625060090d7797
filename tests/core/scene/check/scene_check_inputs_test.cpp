#include "core/scene/check/scene_check.hpp"

#include "tests/core/acceptance.hpp"
#include "tests/core/raw_bones.hpp"
#include "tests/core/raw_drawing.hpp"

#include <doctest/doctest.h>

/// What keys that go by inputs, and inputs, may be.
namespace kfast::test {
namespace {

constexpr std::int32_t widest = kfb::max_input_value;

RawScene with_inputs(std::uint32_t count, const Bytes& inputs)
{
    RawScene scene;
    scene.input_count = count;
    scene.inputs = inputs;
    return scene;
}

bool takes_input(std::int32_t min, std::int32_t max, std::int32_t default_value)
{
    return is_accepted(with_inputs(1, input_bytes("a", min, max, default_value)));
}

/// A drawing, its usual one at the offset.
Bytes drawing_input(std::uint32_t strokes, std::uint32_t points, std::uint32_t default_value)
{
    return joined({bytes({2, 1, 'd'}), varint(strokes), varint(points), varint(default_value)});
}

bool takes_drawing(std::uint32_t strokes, std::uint32_t points, std::uint32_t default_value)
{
    return is_accepted(with_inputs(1, drawing_input(strokes, points, default_value)));
}

/// A scene with a number and a drawing that has these items.
bool takes_live(const Bytes& items)
{
    RawScene scene = with_inputs(2, joined({input_bytes("a"), drawing_input(2, 9, 0)}));
    scene.items = items;
    return is_accepted(scene);
}

/// Two inputs, and a track by one with these keys.
bool takes_track(Driver driver, const std::vector<RawTrackKey>& keys)
{
    RawScene scene = with_inputs(2, joined({input_bytes("a"), input_bytes("b")}));
    scene.items = tracked(1, joined({bytes({0}), track_keys(keys, 0, driver)}));
    return is_accepted(scene);
}

}

TEST_CASE("an input has a range, and its usual value lies in it")
{
    CHECK(takes_input(0, 1, 0));
    CHECK(takes_input(-widest, widest, widest));
    CHECK_FALSE(takes_input(1, 1, 1));
    CHECK_FALSE(takes_input(2, 1, 1));
    CHECK_FALSE(takes_input(0, 10, 11));
    CHECK_FALSE(takes_input(0, 10, -1));
    CHECK_FALSE(takes_input(-widest - 1, 0, 0));
    CHECK_FALSE(takes_input(0, widest + 1, 0));
}

TEST_CASE("inputs have names and a known kind, and there are 32 at most")
{
    CHECK_FALSE(is_accepted(with_inputs(1, input_bytes(""))));
    Bytes other_kind = input_bytes("a");
    other_kind.front() = std::byte{1};
    CHECK_FALSE(is_accepted(with_inputs(1, other_kind)));
    CHECK(is_accepted(with_inputs(32, repeated(input_bytes("a"), 32))));
    CHECK_FALSE(is_accepted(with_inputs(33, repeated(input_bytes("a"), 33))));
    CHECK_FALSE(is_accepted(with_inputs(2, input_bytes("a"))));
    CHECK_FALSE(is_accepted(with_inputs(1, joined({input_bytes("a"), bytes({0})}))));
}

TEST_CASE("keys go by inputs that there are, and lie within their range")
{
    CHECK(takes_track({1}, {{{0}, 0, 1}, {{65536}, 0, 2}}));
    CHECK(takes_track({2}, {{{0}, 0, 1}, {{65536}, 0, 2}}));
    CHECK_FALSE(takes_track({3}, {{{0}, 0, 1}, {{65536}, 0, 2}}));
    for (const int beyond : {33, 34, 65, 255})
        CHECK_FALSE(takes_track({static_cast<std::uint8_t>(beyond)}, {{{0}, 0, 1}, {{65536}, 0, 2}}));
    CHECK_FALSE(takes_track({1}, {{{0}, 0, 1}, {{65537}, 0, 2}}));
    CHECK(takes_track({}, {{{0}, 0, 1}, {{65537}, 0, 2}}));
}

TEST_CASE("so do keys of drawings, and of bones")
{
    RawScene scene = with_inputs(1, input_bytes("a"));
    const auto takes_keys = [&scene](int input, std::int32_t last) {
        scene.items = joined({bytes({0x08, 1}),
                              key_time_bytes({{{0}, 0}, {{last}, 0}}, {static_cast<std::uint8_t>(input)}),
                              value_bytes({0, 10})});
        return is_accepted(scene);
    };
    CHECK(takes_keys(1, 65536));
    CHECK_FALSE(takes_keys(2, 65536));
    CHECK_FALSE(takes_keys(1, 65537));

    scene = with_inputs(1, input_bytes("a"));
    const auto takes_bones = [&scene](int input, std::int32_t last) {
        const Bytes bone = bytes({0, 0xC2, 0, 0, 2}); // x has keys; at 0, 0, two pixels long, and straight
        scene.bones = block(joined(
            {bytes({1, 0}), bone, key_time_bytes({{{0}, 0}, {{last}, 0}}, {static_cast<std::uint8_t>(input)}),
             value_bytes({0, 10})}));
        return is_accepted(scene);
    };
    CHECK(takes_bones(1, 65536));
    CHECK_FALSE(takes_bones(2, 65536));
    CHECK_FALSE(takes_bones(1, 65537));
}

TEST_CASE("a drawing input has room for its usual drawing, which consists of lines")
{
    CHECK(takes_drawing(1, 3, 0)); // the triangle
    CHECK(takes_drawing(4096, 4096, 10));
    CHECK(takes_drawing(1, 1, 10));
    CHECK_FALSE(takes_drawing(1, 2, 0));
    CHECK_FALSE(takes_drawing(0, 4, 10));
    CHECK_FALSE(takes_drawing(1, 0, 10));
    CHECK_FALSE(takes_drawing(5, 4, 10));
    CHECK_FALSE(takes_drawing(1, 4097, 10));
    CHECK_FALSE(takes_drawing(1, 4, 11));
    CHECK_FALSE(takes_drawing(1, 4, 5000));
    const auto takes_two_strokes = [](std::uint32_t strokes) {
        RawScene scene = with_inputs(1, drawing_input(strokes, 9, 0));
        scene.drawings = packed({{polyline_of({{0, 0}, {16, 0}}), polyline_of({{0, 16}, {16, 16}})}});
        scene.items = Bytes{};
        return is_accepted(scene);
    };
    CHECK(takes_two_strokes(2));
    CHECK_FALSE(takes_two_strokes(1)); // though there are points enough
    RawScene scene = with_inputs(1, drawing_input(1, 9, 0));
    const scene::Segment curve{.cubic = true, .c1 = {16, 16}, .c2 = {32, 16}, .to = {48, 0}};
    scene.drawings = packed({{{.from = {}, .segments = {curve}}}});
    scene.items = Bytes{};
    CHECK_FALSE(is_accepted(scene));
}

TEST_CASE("a live item shows a drawing, in a style")
{
    const Bytes filled = bytes({0x0B, 0, 1, 1});
    CHECK(takes_live(filled));
    CHECK(takes_live(bytes({0x33, 0, 1, 1, 16, 5}))); // stroked, the bit of a fill rule is harmless
    CHECK(takes_live(group(filled)));
    CHECK(takes_live(joined({bytes({0x0F, 0, 1}), fixed_track(Property::fill, 2), bytes({1, 1})})));
    CHECK_FALSE(takes_live(joined({bytes({0x0F, 0, 1}), fixed_track(Property::width, 2), bytes({1, 1})})));
    CHECK_FALSE(takes_live(bytes({0x0B, 0, 0, 1}))); // a number
    CHECK_FALSE(takes_live(bytes({0x0B, 0, 2, 1}))); // no input at all
    CHECK_FALSE(takes_live(bytes({0x0B, 9, 1, 1}))); // nothing that can be live
    CHECK_FALSE(takes_live(bytes({0x0B, 0, 1, 9}))); // no such colour
    CHECK_FALSE(takes_live(bytes({0x03, 0, 1})));    // neither fill nor stroke
    CHECK_FALSE(takes_live(bytes({0x4B, 0, 1, 1})));
    CHECK_FALSE(takes_live(bytes({0x8B, 0, 1, 1})));
    CHECK_FALSE(takes_live(bytes({0x0B, 0, 1})));
    CHECK_FALSE(takes_live(bytes({0x0B})));
}

TEST_CASE("keys go by numbers alone")
{
    RawScene scene = with_inputs(2, joined({input_bytes("a"), drawing_input(1, 9, 10)}));
    const auto takes_driver = [&scene](Driver driver) {
        scene.items = tracked(1, joined({bytes({0}), track_keys({{{0}, 0, 1}, {{9}, 0, 2}}, 0, driver)}));
        return is_accepted(scene);
    };
    CHECK(takes_driver({1}));
    CHECK_FALSE(takes_driver({2}));
}

}

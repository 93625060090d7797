#include "core/scene_check.hpp"

#include "tests/core/acceptance.hpp"
#include "tests/core/raw_bones.hpp"

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

bool takes_input(std::int32_t least, std::int32_t most, std::int32_t usual)
{
    return is_accepted(with_inputs(1, input_bytes("a", least, most, usual)));
}

/// Two inputs, and a track by one with these keys.
bool takes_track(Clock clock, const std::vector<RawTrackKey>& keys)
{
    RawScene scene = with_inputs(2, joined({input_bytes("a"), input_bytes("b")}));
    scene.items = tracked(1, joined({bytes({0}), track_keys(keys, 0, clock)}));
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
    CHECK_FALSE(takes_track({1}, {{{0}, 0, 1}, {{65537}, 0, 2}}));
    CHECK(takes_track({}, {{{0}, 0, 1}, {{65537}, 0, 2}}));
}

TEST_CASE("so do keys of drawings, and of bones")
{
    RawScene scene = with_inputs(1, input_bytes("a"));
    const auto takes_keys = [&scene](int input, std::int32_t last) {
        scene.items =
            joined({bytes({0x08, 1}), beat_bytes({{{0}, 0}, {{last}, 0}}, {static_cast<std::uint8_t>(input)}),
                    value_bytes({0, 10})});
        return is_accepted(scene);
    };
    CHECK(takes_keys(1, 65536));
    CHECK_FALSE(takes_keys(2, 65536));
    CHECK_FALSE(takes_keys(1, 65537));

    scene = with_inputs(1, input_bytes("a"));
    const auto takes_bones = [&scene](int input, std::int32_t last) {
        const Bytes bone = bytes({0, 0xC2, 0, 0, 2}); // x has keys; at 0, 0, two pixels long, and straight
        scene.bones = block(joined({bytes({1, 0}), bone,
                                    beat_bytes({{{0}, 0}, {{last}, 0}}, {static_cast<std::uint8_t>(input)}),
                                    value_bytes({0, 10})}));
        return is_accepted(scene);
    };
    CHECK(takes_bones(1, 65536));
    CHECK_FALSE(takes_bones(2, 65536));
    CHECK_FALSE(takes_bones(1, 65537));
}

}

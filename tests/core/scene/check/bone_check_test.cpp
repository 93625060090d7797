#include "core/scene/check/scene_check.hpp"

#include "core/scene/kfb_limits.hpp"
#include "tests/core/acceptance.hpp"
#include "tests/core/raw_bones.hpp"

#include <doctest/doctest.h>
#include <initializer_list>

namespace kfast::test {
namespace {

constexpr std::size_t angle = 0;
constexpr std::size_t x = 1;
constexpr std::size_t y = 2;
constexpr std::size_t length = 3;

/// One pair of laws is stored.
bool takes_section(const Bytes& bones)
{
    RawScene scene;
    scene.law_count = 1;
    scene.laws = bytes({0x21});
    scene.bones = bones;
    return is_accepted(scene);
}

bool takes(const RawSkeleton& skeleton) { return takes_section(skeleton_bytes(skeleton)); }

bool takes_own(std::size_t quantity, const std::vector<RawTrackKey>& keys)
{
    RawBone bone;
    bone.keys[quantity].own = keys;
    return takes({{}, {bone}});
}

bool takes_parents(std::initializer_list<int> parents)
{
    RawSkeleton skeleton;
    for (const int parent : parents)
        skeleton.bones.push_back({.parent = parent});
    return takes(skeleton);
}

RawSkeleton of_bones(std::size_t count) { return {{}, std::vector<RawBone>(count)}; }

}

TEST_CASE("a scene may have no skeletons, or several, each of at least one bone")
{
    CHECK(takes_section({}));
    CHECK(takes(of_bones(1)));
    CHECK(takes_section(repeated(skeleton_bytes(of_bones(2)), 3)));
    CHECK_FALSE(takes(of_bones(0)));
    CHECK_FALSE(takes_section(block({})));
    CHECK_FALSE(takes_section(joined({skeleton_bytes(of_bones(2)), block({})})));
}

TEST_CASE("parents come before their children")
{
    CHECK(takes_parents({0, 1, 2, 1, 0, 5}));
    CHECK_FALSE(takes_parents({1}));
    CHECK_FALSE(takes_parents({0, 2}));
    CHECK_FALSE(takes_parents({0, 3, 1}));
    CHECK_FALSE(takes_parents({255}));
}

TEST_CASE("a bone has a length as it is set up")
{
    RawBone bone{.set_up = {0, 0, 0, 1}};
    CHECK(takes({{}, {bone}}));
    bone.set_up[length] = 0;
    CHECK_FALSE(takes({{}, {bone}}));
    CHECK_FALSE(takes({{}, {{}, bone}}));
}

TEST_CASE("a bone is set up within ranges")
{
    CHECK(takes({{}, {{}, {.parent = 1, .is_at_tip = true, .turns_as_written = true}}}));
    CHECK(takes({{}, {{.set_up = {65535, -32768, 32767, 65535}}}}));
    CHECK_FALSE(takes({{}, {{.set_up = {0, -32769, 0, 1}}}}));
    CHECK_FALSE(takes({{}, {{.set_up = {0, 0, 32768, 1}}}}));
    CHECK_FALSE(takes({{}, {{.set_up = {0, 0, 0, 65536}}}}));
    const auto takes_pixels = [](std::int32_t left, std::uint32_t pixels) { // straight, in whole pixels
        return takes_section(
            block(joined({bytes({1, 0, 0, 0xC0}), signed_varint(left), bytes({0}), varint(pixels)})));
    };
    CHECK(takes_pixels(-2048, 4095));
    CHECK_FALSE(takes_pixels(-2049, 4095));
    CHECK_FALSE(takes_pixels(-2048, 4096));
    CHECK_FALSE(takes_pixels(0, 0x10000000));
}

TEST_CASE("common keys rise in time and have known laws")
{
    RawBone bone;
    bone.keys[y].common = {-32768, 32767};
    const auto takes_times = [&bone](RawCommonKey first, RawCommonKey second) {
        return takes({{first, second}, {bone}});
    };
    CHECK(takes_times({{}, 1}, {{1}, 0}));
    CHECK(takes_times({{7}, 1}, {{kfb::max_time}, 0}));
    CHECK_FALSE(takes_times({{7}, 0}, {{7}, 0}));
    CHECK_FALSE(takes_times({{7}, 2}, {{8}, 0}));
    CHECK_FALSE(takes_times({{7}, 0}, {{8}, 2}));
    CHECK_FALSE(takes_times({{7}, 0}, {Time::frame(1'000'001), 0}));
}

TEST_CASE("common beats that add up to more than any time are refused")
{
    const Bytes late = joined({bytes({4, 0xFF, 0x01}), repeated(bytes({0xFF}), 16)});
    CHECK_FALSE(takes_section(block(joined({bytes({1}), late, bone_bytes({})}))));
}

TEST_CASE("what goes by the common keys needs some")
{
    RawBone bone;
    bone.keys[x].common = {5};
    CHECK(takes({{{{}, 0}}, {bone}}));
    CHECK_FALSE(takes({{}, {bone}}));
    bone.turns_as_written = true;
    bone.keys[angle].common = {-70'000};
    CHECK(takes({{{{}, 0}}, {bone}}));
}

TEST_CASE("values of a bone's own keys have ranges")
{
    const auto check_range = [](std::size_t quantity, std::int32_t min, std::int32_t max) {
        CAPTURE(quantity);
        CHECK(takes_own(quantity, {{{}, 0, min}, {{1}, 0, max}}));
        CHECK_FALSE(takes_own(quantity, {{{}, 0, min - 1}, {{1}, 0, max}}));
        CHECK_FALSE(takes_own(quantity, {{{}, 0, min}, {{1}, 0, max + 1}}));
    };
    check_range(angle, -1'048'576, 1'048'576);
    check_range(x, -32'768, 32'767);
    check_range(y, -32'768, 32'767);
    check_range(length, 0, 65'535);
}

TEST_CASE("a bone's own keys rise in time and have known laws")
{
    for (std::size_t quantity = 0; quantity < bone_quantity_count; ++quantity) {
        CHECK(takes_own(quantity, {{{}, 1, 5}, {{kfb::max_time}, 0, 6}}));
        CHECK_FALSE(takes_own(quantity, {{{3}, 0, 5}, {{3}, 0, 6}}));
        CHECK_FALSE(takes_own(quantity, {{{}, 2, 5}}));
        CHECK_FALSE(takes_own(quantity, {{{}, 0, 5}, {Time::frame(1'000'001), 0, 6}}));
    }
}

TEST_CASE("a skeleton ends where it says")
{
    RawBone bone;
    bone.keys[y].common = {1, 2};
    bone.keys[length].own = {{{}, 0, 9}};
    const Bytes whole = skeleton_bytes({{{{}, 0}, {{1}, 0}}, {bone, bone}});
    const Bytes inside{whole.begin() + 1, whole.end()};
    CHECK(takes_section(block(inside)));
    for (std::size_t size = 0; size < inside.size(); ++size) {
        const Bytes cut{inside.begin(), inside.begin() + static_cast<std::ptrdiff_t>(size)};
        CHECK_FALSE(takes_section(block(cut)));
        CHECK_FALSE(takes_section(joined({bytes({static_cast<int>(inside.size())}), cut})));
    }
    CHECK_FALSE(takes_section(block(joined({inside, bytes({0})}))));
}

TEST_CASE("all skeletons together have at most 1024 bones, and are at most 255")
{
    const Bytes largest = repeated(skeleton_bytes(of_bones(255)), 4);
    CHECK(takes_section(joined({largest, skeleton_bytes(of_bones(4))})));
    CHECK_FALSE(takes_section(joined({largest, skeleton_bytes(of_bones(5))})));
    CHECK(takes_section(repeated(skeleton_bytes(of_bones(1)), 255)));
    CHECK_FALSE(takes_section(repeated(skeleton_bytes(of_bones(1)), 256)));
}

}

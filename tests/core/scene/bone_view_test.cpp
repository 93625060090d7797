#include "core/scene/skeleton_view.hpp"

#include "tests/core/raw_bones.hpp"

#include <doctest/doctest.h>
#include <limits>

namespace kfast::test {
namespace {

SkeletonView only(const Bytes& section) { return SkeletonCursor{ByteReader{section}}.next(); }

}

TEST_CASE("bones are read as they are set up, whatever keys they have")
{
    RawBone root{.set_up = {65535, -32768, 32767, 65535}};
    root.keys[0].own = {{Time::frame(1), 2, -70'000}, {Time::frame(3), 0, 9}};
    root.keys[2].common = {-5, 6};
    const RawBone child{.parent = 1, .is_at_tip = true, .set_up = {1, 2, 3, 4}};
    const RawBone free{.turns_as_written = true, .set_up = {4, 3, 2, 1}};
    const Bytes section = skeleton_bytes({{{Time::frame(2), 1}, {{2049}, 3}}, {root, child, free}});
    SkeletonCursor skeletons{ByteReader{section}};
    const SkeletonView bones = skeletons.next();
    CHECK(skeletons.at_end());
    CHECK_FALSE(skeletons.overrun());
    CHECK(bones.count() == 3);
    BoneCursor cursor = bones.bones();
    const BoneView first = cursor.next();
    CHECK(first.parent == 0);
    CHECK_FALSE(first.is_at_tip);
    CHECK_FALSE(first.turns_as_written);
    CHECK(first.set_up == std::array{65535, -32768, 32767, 65535});
    CHECK(first.at_rest(BoneQuantity::y) == 32767);
    CHECK(first.keys_of(BoneQuantity::angle).kind() == BoneKeys::Kind::own);
    CHECK(first.keys_of(BoneQuantity::x).kind() == BoneKeys::Kind::none);
    CHECK(first.keys_of(BoneQuantity::y).kind() == BoneKeys::Kind::common);
    CHECK(first.keys_of(BoneQuantity::length).kind() == BoneKeys::Kind::none);
    const BoneView second = cursor.next();
    CHECK(second.parent == 1);
    CHECK(second.is_at_tip);
    CHECK(second.set_up == std::array{1, 2, 3, 4});
    const BoneView third = cursor.next();
    CHECK(third.turns_as_written);
    CHECK_FALSE(third.is_at_tip);
    CHECK(third.set_up == std::array{4, 3, 2, 1});
    CHECK(cursor.at_end());
    CHECK(cursor.rest().left() == 0);
    CHECK_FALSE(cursor.rest().overrun());
}

TEST_CASE("a bone that is straight, and in whole pixels, says so and no more")
{
    const Bytes section = block(bytes({2, 0, 0, 0xC0, 6, 5, 0x80, 32, 1, 0x80, 0x34, 0x12, 0, 1, 2}));
    BoneCursor cursor = only(section).bones();
    CHECK(cursor.next().set_up == std::array{0, 48, -48, 65536});
    CHECK(cursor.next().set_up == std::array{0x1234, 0, -16, 32});
    CHECK(cursor.rest().left() == 0);
}

TEST_CASE("common beats have times and laws, and each quantity a value for each, apart from its set-up")
{
    RawBone bone{.set_up = {40'000, -100, 100, 30'000}};
    bone.keys[0].common = {65535, 0, 7};
    bone.keys[1].common = {-1, -32768, 32767};
    bone.keys[3].common = {32768, 65535, 0};
    const Bytes section = skeleton_bytes({{{Time::frame(2), 1}, {{2049}, 3}, {Time::frame(9)}}, {bone}});
    KeyTimeCursor key_times = only(section).common_key_times();
    CHECK(key_times.count() == 3);
    CHECK(key_times.next().time == Time::frame(2));
    const KeyTime second = key_times.next();
    CHECK(second.time == Time{2049});
    CHECK(second.laws == 3);
    const BoneView view = only(section).bones().next();
    for (const auto quantity : {BoneQuantity::angle, BoneQuantity::x, BoneQuantity::length}) {
        const BoneKeys& keys = view.keys_of(quantity);
        CHECK(keys.kind() == BoneKeys::Kind::common);
        TrackKeyCursor cursor = keys.keys();
        for (std::uint32_t index = 0; index < 3; ++index) {
            const std::int32_t value = bone.keys[static_cast<std::size_t>(quantity)].common[index];
            CHECK(keys.values()[index] == value - view.at_rest(quantity));
            CHECK(cursor.next().value == value);
        }
        CHECK(cursor.at_end());
    }
}

TEST_CASE("keys of a bone's own are those of tracks")
{
    RawBone bone{.set_up = {9, 0, 0, 16}};
    bone.keys[0].own = {{Time::frame(1), 2, -70'000}, {{1025}, 3, 1'048'576}};
    const Bytes section = skeleton_bytes({{}, {bone}});
    TrackKeyCursor keys = only(section).bones().next().keys_of(BoneQuantity::angle).keys();
    const TrackKey first = keys.next();
    CHECK(first.time == Time::frame(1));
    CHECK(first.laws == 2);
    CHECK(first.value == -70'000);
    const TrackKey second = keys.next();
    CHECK(second.time == Time{1025});
    CHECK(second.value == 1'048'576);
    CHECK(keys.at_end());
}

TEST_CASE("skeletons and bones that break off are noticed")
{
    RawBone bone;
    bone.keys[0].own = {{{}, 0, 7}};
    bone.keys[1].common = {1, 2};
    const Bytes section = skeleton_bytes({{{{}, 0}, {{1}, 0}}, {bone}});
    const std::size_t size = section.size() - 1;
    for (std::size_t left = 0; left < size; ++left) {
        const Bytes cut = block(Bytes(section.begin() + 1, section.begin() + 1 + static_cast<long>(left)));
        const SkeletonView bones = only(cut);
        if (bones.count() == 0)
            continue;
        BoneCursor cursor = bones.bones();
        cursor.next();
        CHECK(cursor.rest().overrun());
    }
    SkeletonCursor skeletons{ByteReader{std::span{section}.first(size)}};
    skeletons.next();
    CHECK(skeletons.overrun());
}

TEST_CASE("skeletons are passed with nothing but the number of their bones")
{
    const Bytes section = joined({skeleton_bytes({{{Time::frame(2), 1}}, {RawBone{}, RawBone{}}}),
                                  skeleton_bytes({{}, {RawBone{}}}), block(bytes({}))});
    SkeletonCursor skeletons{ByteReader{section}};
    CHECK(skeletons.skip() == 2);
    CHECK(skeletons.skip() == 1);
    CHECK_FALSE(skeletons.at_end());
    CHECK(skeletons.skip() == 0);
    CHECK(skeletons.at_end());
    CHECK_FALSE(skeletons.overrun());
}

}

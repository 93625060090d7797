#include "host/compiler/write/bone_writer.hpp"

#include "core/scene/skeleton_view.hpp"
#include "tests/bytes.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

scene::TrackKey at(int frame, std::int32_t value, LawPair laws = {})
{
    return {.time = Time::frame(frame), .laws = laws, .value = value};
}

constexpr LawPair soft{VelocityLaw::accelerate, VelocityLaw::accelerate};

std::vector<std::byte> written(const std::vector<scene::Bones>& skeletons)
{
    LawTable laws;
    ByteWriter bytes;
    write_bones(skeletons, laws, bytes);
    return bytes.bytes();
}

scene::Bone bone(std::array<std::int32_t, bone_quantity_count> set_up,
                 std::optional<std::size_t> parent = std::nullopt)
{
    scene::Bone bone;
    bone.set_up = set_up;
    bone.parent = parent;
    return bone;
}

BoneKeys::Kind kind(const BoneView& view, BoneQuantity quantity) { return view.keys_of(quantity).kind(); }

}

TEST_CASE("skeletons, byte by byte")
{
    scene::Bone root = bone({49152, 1920, -16, 960});
    root.keys[0] = {at(0, 49152, soft), at(12, 40000)};
    scene::Bone child = bone({65535, 960, 0, 512}, 0);
    child.is_at_tip = true;
    child.keys[0] = {at(0, 30000, soft), at(12, 31000)};
    child.keys[2] = {at(5, -3)};
    const scene::Bones robot{.name = "robot", .bones = {root, child}, .place = {}};
    const scene::Bones still{.name = "still", .bones = {bone({1, 2, 3, 4})}, .place = {}};
    CHECK(written({robot, still}) ==
          bytes({
              39, 2,                                  // two bones
              2,  0x82, 0x03, 0x38,                   // common key times: times in 4 frames; laws 1 and 0
              0,  0x81, 0x00, 0xC0, 0xF0, 1, 1,  60,  // root
              0,  0xC8, 0x9D, 2,    0x8F, 0,          // its angles, in 64 units: 0, -143
              1,  0x95, 0xFF, 0xFF, 120,  0, 32,      // child
              0,  10,   0xE2, 0xD4, 3,    0, 62, 128, // its angles: 30001, 31001
              1,  0x43, 1,    0xA0, 5,                // y, keys of its own
              9,  1,    0,    0,    0,    1, 0,  4,   6, 4,
          }));
}

TEST_CASE("the times and laws that save most are common")
{
    scene::Bones skeleton{.name = "s", .bones = {}, .place = {}};
    for (int i = 0; i < 3; ++i) {
        skeleton.bones.push_back(bone({0, 0, 0, 16}));
        skeleton.bones.back().keys[0] = {at(0, 20000 + i), at(10, 30000), at(20, 30001)};
    }
    skeleton.bones[0].keys[3] = {at(0, 2000), at(10, 3000), at(20, 1000)};
    skeleton.bones[1].keys[3] = {at(0, 2000), at(10, 3000), at(21, 1000)};
    skeleton.bones[2].keys[3] = {at(0, 2000), at(10, 3000, soft), at(20, 1000)};
    skeleton.bones[2].keys[1] = {at(0, 20000), at(10, 20000), at(20, 20000)};
    skeleton.bones[1].turns_as_written = true;
    const std::vector<std::byte> bytes = written({skeleton});
    SkeletonCursor cursor{ByteReader{bytes}};
    const SkeletonView view = cursor.next();
    CHECK(view.common_key_times().count() == 3);
    BoneCursor bones = view.bones();
    const BoneView first = bones.next();
    CHECK(kind(first, BoneQuantity::angle) == BoneKeys::Kind::common);
    CHECK(kind(first, BoneQuantity::length) == BoneKeys::Kind::common);
    const BoneView second = bones.next();
    CHECK(second.turns_as_written);
    CHECK(kind(second, BoneQuantity::angle) == BoneKeys::Kind::common);
    CHECK(kind(second, BoneQuantity::length) == BoneKeys::Kind::own);
    const BoneView third = bones.next();
    CHECK(kind(third, BoneQuantity::angle) == BoneKeys::Kind::common);
    CHECK(kind(third, BoneQuantity::x) == BoneKeys::Kind::common);
    CHECK(kind(third, BoneQuantity::length) == BoneKeys::Kind::own);
    CHECK(kind(third, BoneQuantity::y) == BoneKeys::Kind::none);
    CHECK(third.keys_of(BoneQuantity::angle).keys().next().value == 20002);
}

TEST_CASE("beats of one quantity alone are not common")
{
    scene::Bones skeleton{.name = "s", .bones = {bone({0, 0, 0, 16})}, .place = {}};
    skeleton.bones[0].keys[0] = {at(0, 100), at(10, 200)};
    const std::vector<std::byte> bytes = written({skeleton});
    SkeletonCursor cursor{ByteReader{bytes}};
    CHECK(cursor.next().common_key_times().count() == 0);
}

TEST_CASE("angles that count modulo one turn are stored near the bone as set up")
{
    scene::Bones skeleton{.name = "s", .bones = {bone({0, 0, 0, 16})}, .place = {}};
    skeleton.bones[0].keys[0] = {at(0, 65530)};
    std::vector<std::byte> bytes = written({skeleton});
    SkeletonCursor cursor{ByteReader{bytes}};
    CHECK(cursor.next().bones().next().keys_of(BoneQuantity::angle).keys().next().value == -6);
    skeleton.bones[0].turns_as_written = true;
    bytes = written({skeleton});
    CHECK(SkeletonCursor{ByteReader{bytes}}
              .next()
              .bones()
              .next()
              .keys_of(BoneQuantity::angle)
              .keys()
              .next()
              .value == 65530);
}

}

#include "tests/host/compiler/bone_comparison.hpp"

#include "tests/host/compiler/law_comparison.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

void compare_bone_keys(const SceneView& view, const BoneKeys& read, const std::vector<scene::TrackKey>& keys,
                       bool is_modular)
{
    REQUIRE((read.kind() == BoneKeys::Kind::none) == keys.empty());
    TrackKeyCursor cursor = read.keys();
    for (const scene::TrackKey& key : keys) {
        REQUIRE_FALSE(cursor.at_end());
        const TrackKey stored = cursor.next();
        CHECK(stored.time == key.time);
        CHECK((is_modular ? stored.value & 0xFFFF : stored.value) == key.value);
        compare_laws(view, stored.laws, key.laws, &key == &keys.back());
    }
    CHECK(cursor.at_end());
}

void compare_bone(const SceneView& view, const BoneView& read, const scene::Bone& bone)
{
    CHECK(read.parent == (bone.parent ? *bone.parent + 1 : 0));
    CHECK(read.is_at_tip == bone.is_at_tip);
    CHECK(read.set_up == bone.set_up);
    if (!bone.keys[0].empty())
        CHECK(read.turns_as_written == bone.turns_as_written);
    for (std::size_t i = 0; i < bone_quantity_count; ++i) {
        const bool is_modular = i == 0 && !bone.turns_as_written;
        compare_bone_keys(view, read.keys[i], bone.keys[i], is_modular);
        if (bone.keys[i].size() > 1) // a single one is the same by any clock
            CHECK(read.keys[i].keys().key_times().driver() == bone.driver);
    }
}

}

void compare_skeletons(const SceneView& view, const std::vector<scene::Bones>& skeletons)
{
    SkeletonCursor cursor = view.skeletons();
    for (const scene::Bones& skeleton : skeletons) {
        REQUIRE(!cursor.at_end());
        const SkeletonView read = cursor.next();
        REQUIRE(read.count() == skeleton.bones.size());
        BoneCursor bones = read.bones();
        for (const scene::Bone& bone : skeleton.bones)
            compare_bone(view, bones.next(), bone);
    }
    CHECK(cursor.at_end());
}

}

#pragma once

#include "tests/core/raw_bones.hpp"

#include <cstdint>
#include <random>
#include <vector>

namespace kfast::test {

inline int within(std::mt19937& random, int min, int max)
{
    return std::uniform_int_distribution<int>{min, max}(random);
}

inline std::int32_t random_value(std::mt19937& random, const RawBone& bone, std::size_t quantity)
{
    switch (static_cast<BoneQuantity>(quantity)) {
    case BoneQuantity::angle:
        return within(random, 0, 65535);
    case BoneQuantity::x:
    case BoneQuantity::y:
        return bone.set_up[quantity] + within(random, -16 * 20, 16 * 20);
    case BoneQuantity::length:
        return random() % 4 == 0 ? 0 : within(random, 0, 2 * bone.set_up[quantity]);
    }
    return 0;
}

inline std::vector<RawTrackKey> random_own_keys(std::mt19937& random, const RawBone& bone,
                                                std::size_t quantity)
{
    std::vector<RawTrackKey> keys(1 + random() % 3);
    Time time{within(random, 0, 2000)};
    for (RawTrackKey& key : keys) {
        key = {time, within(random, 0, 4), random_value(random, bone, quantity)};
        if (bone.turns_as_written && quantity == of_bone::angle)
            key.value = within(random, -65536, 65536);
        time.ticks += within(random, 1, 5000);
    }
    return keys;
}

inline void add_random_keys(std::mt19937& random, std::size_t common_keys, RawBone& bone)
{
    for (std::size_t quantity = 0; quantity < 4; ++quantity) {
        if (random() % 2 == 0)
            continue;
        RawBoneKeys& keys = bone.keys[quantity];
        const bool must_be_own = common_keys == 0 || (bone.turns_as_written && quantity == of_bone::angle);
        if (must_be_own || random() % 2 == 0)
            keys.own = random_own_keys(random, bone, quantity);
        else
            for (std::size_t i = 0; i < common_keys; ++i)
                keys.common.push_back(random_value(random, bone, quantity));
    }
}

/// Begins on the tip or along its parent; a root begins on the canvas, 512 px wide and high.
inline RawBone random_bone(std::mt19937& random, const std::vector<RawBone>& earlier, int parent)
{
    RawBone bone{.parent = parent};
    bone.set_up = {within(random, 0, 65535), within(random, 0, 512 * 16), within(random, 0, 512 * 16),
                   within(random, 4 * 16, 60 * 16)};
    if (parent == 0)
        return bone;
    bone.is_at_tip = random() % 2 == 0;
    const std::int32_t parent_length = earlier[static_cast<std::size_t>(parent) - 1].set_up[of_bone::length];
    bone.set_up[of_bone::x] = bone.is_at_tip ? parent_length : within(random, 0, parent_length);
    bone.set_up[of_bone::y] = random() % 2 == 0 ? 0 : within(random, -160, 160);
    return bone;
}

enum class Turns { shortest, as_written };

/// One root or several, with bones up to eight levels deep; its keys have the laws of a Puppet.
inline RawSkeleton random_skeleton(std::mt19937& random, Turns turns = Turns::shortest)
{
    RawSkeleton skeleton;
    Time time{within(random, 0, 2000)};
    for (auto count = random() % 4; count > 0; --count) {
        skeleton.common.push_back({time, within(random, 0, 4)});
        time.ticks += within(random, 1, 5000);
    }
    std::vector<int> levels{0};
    for (auto count = 1 + random() % 12; count > 0; --count) {
        int parent = static_cast<int>(skeleton.bones.size()); // mostly in a chain
        if (random() % 3 == 0 || levels.back() == 8)
            parent = within(random, 0, parent);
        const int level = levels[static_cast<std::size_t>(parent)] + 1;
        if (level > 8)
            continue;
        levels.push_back(level);
        skeleton.bones.push_back(random_bone(random, skeleton.bones, parent));
        RawBone& bone = skeleton.bones.back();
        bone.turns_as_written = turns == Turns::as_written && random() % 2 == 0;
        add_random_keys(random, skeleton.common.size(), bone);
    }
    return skeleton;
}

}

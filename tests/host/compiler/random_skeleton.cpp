#include "tests/host/compiler/random_skeleton.hpp"

#include "tests/host/compiler/random_keys.hpp"

#include <array>
#include <cstdint>

namespace kfast::test {
namespace {

std::int32_t random_value(Dice& dice, BoneQuantity quantity, bool turns_as_written)
{
    if (quantity == BoneQuantity::angle)
        return turns_as_written ? dice.within(-100'000, 100'000) : dice.within(0, 65535);
    return quantity == BoneQuantity::length ? dice.within(0, 3000) : dice.within(-3000, 3000);
}

std::vector<scene::TrackKey> random_poses(Dice& dice)
{
    std::vector<scene::TrackKey> keys;
    RisingTimes times{dice};
    for (int left = dice.within(1, 6); left > 0; --left)
        keys.push_back({.time = times.next(), .laws = random_laws(dice), .value = 0});
    return keys;
}

/// `poses`: the keys of the bones before, which it often has in common with them.
scene::Bone random_bone(Dice& dice, std::vector<scene::TrackKey>& poses)
{
    scene::Bone bone;
    bone.name = dice.name();
    bone.turns_as_written = dice.sometimes();
    bone.set_up = {dice.within(0, 65535), dice.within(-3000, 3000), dice.within(-3000, 3000),
                   dice.within(1, 2000)};
    if (dice.sometimes())
        poses = random_poses(dice);
    for (std::size_t i = 0; i < bone.keys.size(); ++i)
        if (dice.sometimes()) {
            bone.keys[i] = poses;
            for (scene::TrackKey& key : bone.keys[i])
                key.value = random_value(dice, static_cast<BoneQuantity>(i), bone.turns_as_written);
        }
    return bone;
}

}

std::vector<scene::Bone> random_bones(Dice& dice)
{
    std::vector<scene::TrackKey> poses = random_poses(dice);
    std::vector<scene::Bone> bones;
    for (int left = dice.within(1, 5); left > 0; --left) {
        scene::Bone next = random_bone(dice, poses);
        if (!bones.empty() && !dice.sometimes()) {
            next.parent = dice.below(bones.size());
            next.is_at_tip = dice.sometimes();
        }
        bones.push_back(std::move(next));
    }
    return bones;
}

std::vector<scene::Bone> moderate_bones(Dice& dice)
{
    std::vector<scene::Bone> all = random_bones(dice);
    for (scene::Bone& bone : all) {
        bone.set_up = {dice.within(0, 65535), dice.within(-640, 640), dice.within(-640, 640),
                       dice.within(320, 960)};
        const std::array<std::int32_t, bone_quantity_count> spread{0, 160, 160, 300};
        for (std::size_t i = 0; i < bone.keys.size(); ++i)
            for (scene::TrackKey& key : bone.keys[i]) {
                key.laws = soft_laws(dice);
                if (i != 0)
                    key.value = bone.set_up[i] + dice.within(-spread[i], spread[i]);
            }
    }
    return all;
}

}

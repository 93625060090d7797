#pragma once

#include "core/bone_quantity.hpp"
#include "tests/core/raw_scene.hpp"

#include <array>
#include <cstdint>
#include <vector>

/// Skeletons of bones put together by hand (docs/format.md, "Bones").
namespace kfast::test {

/// None of both if the quantity has no keys.
struct RawBoneKeys {
    std::vector<std::int32_t> common; ///< a value for each common key
    std::vector<RawTrackKey> own;
};

struct RawBone {
    int parent = 0; ///< counted from 1; 0 for a root
    bool is_at_tip = false;
    bool turns_as_written = false;
    std::array<std::int32_t, bone_quantity_count> set_up{0, 0, 0, 16};
    std::array<RawBoneKeys, bone_quantity_count> keys = {};
    int more_bits = 0;
};

struct RawCommonKey {
    Time time;
    int laws = 0;
};

struct RawSkeleton {
    std::vector<RawCommonKey> common;
    std::vector<RawBone> bones;
};

inline Bytes u16(std::int32_t value) { return bytes({value & 255, value >> 8 & 255}); }

inline Bytes bone_keys(const RawBoneKeys& keys)
{
    if (!keys.own.empty())
        return block(track_keys(keys.own));
    Bytes values = bytes({0});
    for (const std::int32_t value : keys.common)
        values = joined({values, u16(value)});
    return values;
}

inline Bytes bone_bytes(const RawBone& bone)
{
    int head = bone.more_bits | (bone.is_at_tip ? 0x10 : 0) | (bone.turns_as_written ? 0x20 : 0);
    Bytes numbers;
    for (const std::int32_t value : bone.set_up)
        numbers = joined({numbers, u16(value)});
    for (std::size_t i = 0; i < bone_quantity_count; ++i)
        if (const RawBoneKeys& keys = bone.keys[i]; !keys.common.empty() || !keys.own.empty()) {
            head |= 1 << i;
            numbers = joined({numbers, bone_keys(keys)});
        }
    return joined({bytes({bone.parent, head}), numbers});
}

/// As the section of bones has it.
inline Bytes skeleton_bytes(const RawSkeleton& skeleton)
{
    Bytes all = joined({bytes({static_cast<int>(skeleton.bones.size())}),
                        varint(static_cast<std::uint32_t>(skeleton.common.size()))});
    Time before;
    for (const RawCommonKey& key : skeleton.common) {
        all = joined({all, varint(time_code(key.time - before)), bytes({key.laws})});
        before = key.time;
    }
    for (const RawBone& bone : skeleton.bones)
        all = joined({all, bone_bytes(bone)});
    return block(all);
}

}

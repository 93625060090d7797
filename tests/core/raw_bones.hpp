#pragma once

#include "core/scene/skeleton_view.hpp"
#include "tests/core/raw_scene.hpp"

#include <array>
#include <cstdint>
#include <vector>

/// Skeletons of bones put together by hand (docs/format.md, "Bones").
namespace kfast::test {

/// The indices of a bone's quantities.
namespace of_bone {
inline constexpr auto angle = static_cast<std::size_t>(BoneQuantity::angle);
inline constexpr auto x = static_cast<std::size_t>(BoneQuantity::x);
inline constexpr auto y = static_cast<std::size_t>(BoneQuantity::y);
inline constexpr auto length = static_cast<std::size_t>(BoneQuantity::length);
}

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

/// Of a quantity that is set up as `from`.
inline Bytes bone_keys(const RawBoneKeys& keys, std::int32_t from)
{
    if (!keys.own.empty())
        return track_keys(keys.own, from);
    std::vector<std::int32_t> values = keys.common;
    for (std::int32_t& value : values)
        value -= from;
    return joined({bytes({0}), value_bytes(values)});
}

inline Bytes bone_bytes(const RawBone& bone)
{
    int head = (bone.is_at_tip ? 0x10 : 0) | (bone.turns_as_written ? 0x20 : 0);
    Bytes numbers = joined({u16(bone.set_up[0]), signed_varint(bone.set_up[1]), signed_varint(bone.set_up[2]),
                            varint(static_cast<std::uint32_t>(bone.set_up[3]))});
    for (std::size_t i = 0; i < bone_quantity_count; ++i)
        if (const RawBoneKeys& keys = bone.keys[i]; !keys.common.empty() || !keys.own.empty()) {
            head |= 1 << i;
            numbers = joined({numbers, bone_keys(keys, bone.set_up[i])});
        }
    return joined({bytes({bone.parent, head}), numbers});
}

/// As the section of bones has it.
inline Bytes skeleton_bytes(const RawSkeleton& skeleton)
{
    KeyTimes common;
    for (const RawCommonKey& key : skeleton.common)
        common.push_back({key.time, static_cast<std::uint32_t>(key.laws)});
    Bytes all = joined({bytes({static_cast<int>(skeleton.bones.size())}), key_time_bytes(common)});
    for (const RawBone& bone : skeleton.bones)
        all = joined({all, bone_bytes(bone)});
    return block(all);
}

}

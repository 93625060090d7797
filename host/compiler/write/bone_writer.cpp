#include "host/compiler/write/bone_writer.hpp"

#include "core/math/angle.hpp"
#include "core/scene/format.hpp"
#include "core/scene/skeleton_view.hpp"
#include "host/compiler/pack/key_time_writer.hpp"
#include "host/compiler/pack/value_writer.hpp"
#include "host/compiler/write/track_writer.hpp"

#include <cstddef>
#include <map>

namespace kfast {
namespace {

using Keys = std::vector<scene::TrackKey>;

/// The value as set up, in the format's unit.
std::int32_t set_up(const scene::Bone& bone, BoneQuantity quantity)
{
    const std::int32_t value = bone.set_up[static_cast<std::size_t>(quantity)];
    return quantity == BoneQuantity::angle ? static_cast<std::uint16_t>(value) : value;
}

bool is_straight(const scene::Bone& bone) { return set_up(bone, BoneQuantity::angle) == 0; }

bool is_in_pixels(const scene::Bone& bone)
{
    const auto is_whole = [&bone](BoneQuantity quantity) { return set_up(bone, quantity) % 16 == 0; };
    return is_whole(BoneQuantity::x) && is_whole(BoneQuantity::y) && is_whole(BoneQuantity::length);
}

/// Differences from the bone as set up; an angle that counts modulo one turn as the smallest one.
std::vector<std::int32_t> stored_values(const scene::Bone& bone, BoneQuantity quantity, const Keys& keys)
{
    const std::int32_t from = set_up(bone, quantity);
    std::vector<std::int32_t> values = values_of(keys);
    for (std::int32_t& value : values)
        value = quantity == BoneQuantity::angle && !bone.turns_as_written
                    ? shortest_turn(BinaryAngle::from_raw(from), BinaryAngle::from_raw(value))
                    : value - from;
    return values;
}

class SkeletonWriter {
public:
    SkeletonWriter(const scene::Bones& skeleton, LawTable& laws) : skeleton_{skeleton}, laws_{laws}
    {
        choose_common_key_times();
    }

    std::vector<std::byte> write()
    {
        ByteWriter bytes;
        bytes.u8(static_cast<std::uint32_t>(skeleton_.bones.size()));
        write_key_times(common_, {}, bytes);
        for (const scene::Bone& bone : skeleton_.bones)
            write_bone(bone, bytes);
        return bytes.bytes();
    }

private:
    /// Chooses those that save most: all quantities that have them store only their values.
    void choose_common_key_times()
    {
        std::map<DrivenKeyTimes, std::size_t> uses;
        for (const scene::Bone& bone : skeleton_.bones)
            for (const Keys& keys : bone.keys)
                if (!keys.empty())
                    ++uses[key_times_of(keys, bone.driver, false, laws_)];
        std::size_t max = 0;
        for (const auto& [driven, count] : uses)
            if (const std::size_t saved = (count - 1) * driven.key_times.size(); saved > max) {
                max = saved;
                common_ = driven;
            }
    }

    void write_bone(const scene::Bone& bone, ByteWriter& bytes)
    {
        bytes.u8(bone.parent ? static_cast<std::uint32_t>(*bone.parent) + 1 : 0);
        bytes.u8(flags_of(bone));
        write_set_up(bone, bytes);
        for (std::size_t i = 0; i < bone_quantity_count; ++i)
            if (!bone.keys[i].empty())
                write_keys(bone, static_cast<BoneQuantity>(i), bytes);
    }

    static std::uint32_t flags_of(const scene::Bone& bone)
    {
        std::uint32_t moved = 0;
        for (std::size_t i = 0; i < bone_quantity_count; ++i)
            moved |= bone.keys[i].empty() ? 0 : 1U << i;
        const bool turns = !bone.keys[static_cast<std::size_t>(BoneQuantity::angle)].empty();
        return kfb::bone::moved.put(moved) | kfb::bone::is_at_tip.put(bone.is_at_tip) |
               kfb::bone::turns_as_written.put(turns && bone.turns_as_written) |
               kfb::bone::is_straight.put(is_straight(bone)) | kfb::bone::in_pixels.put(is_in_pixels(bone));
    }

    static void write_set_up(const scene::Bone& bone, ByteWriter& bytes)
    {
        const std::int32_t unit = is_in_pixels(bone) ? 16 : 1;
        if (!is_straight(bone))
            bytes.u16(static_cast<std::uint32_t>(set_up(bone, BoneQuantity::angle)));
        bytes.signed_varint(set_up(bone, BoneQuantity::x) / unit);
        bytes.signed_varint(set_up(bone, BoneQuantity::y) / unit);
        bytes.varint(static_cast<std::uint32_t>(set_up(bone, BoneQuantity::length) / unit));
    }

    void write_keys(const scene::Bone& bone, BoneQuantity quantity, ByteWriter& bytes)
    {
        const Keys& keys = bone.keys[static_cast<std::size_t>(quantity)];
        write_key_times(key_times_of(keys, bone.driver, false, laws_), common_, bytes);
        write_values(stored_values(bone, quantity, keys), bytes);
    }

    const scene::Bones& skeleton_;
    LawTable& laws_;
    DrivenKeyTimes common_;
};

}

void write_bones(const std::vector<scene::Bones>& skeletons, LawTable& laws, ByteWriter& bytes)
{
    for (const scene::Bones& skeleton : skeletons)
        bytes.block(SkeletonWriter{skeleton, laws}.write());
}

}

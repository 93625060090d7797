#include "host/compiler/bone_writer.hpp"

#include "core/angle.hpp"
#include "host/compiler/time_code.hpp"
#include "host/compiler/track_writer.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

namespace kfast {
namespace {

using Keys = std::vector<scene::TrackKey>;

constexpr std::uint32_t at_tip_bit = 1 << 4;
constexpr std::uint32_t as_written_bit = 1 << 5;

/// When keys are and what governs their ways.
using Beats = std::vector<std::pair<std::int32_t, std::uint32_t>>; ///< ticks, number of the pair of laws

Beats beats_of(const Keys& keys, LawTable& laws)
{
    Beats beats;
    for (const scene::TrackKey& key : keys)
        beats.emplace_back(key.time.ticks, &key == &keys.back() ? 0 : laws.number_of(key.laws, key.place));
    return beats;
}

std::vector<std::byte> packed(const Beats& beats)
{
    ByteWriter bytes;
    std::int32_t before = 0;
    for (const auto& [ticks, laws] : beats) {
        bytes.varint(time_code({ticks - before}));
        bytes.u8(laws);
        before = ticks;
    }
    return bytes.bytes();
}

bool turns_as_written(const scene::Bone& bone, BoneQuantity quantity)
{
    return quantity == BoneQuantity::angle && bone.turns_as_written;
}

bool fits_in_16_bits(const scene::TrackKey& key, BoneQuantity quantity)
{
    switch (quantity) {
    case BoneQuantity::angle:
        return true; // counts modulo one turn
    case BoneQuantity::x:
    case BoneQuantity::y:
        return key.value >= -32768 && key.value <= 32767;
    case BoneQuantity::length:
        return key.value >= 0 && key.value <= 65535;
    }
    return false;
}

bool may_be_common(const scene::Bone& bone, BoneQuantity quantity, const Keys& keys)
{
    const auto fits = [quantity](const scene::TrackKey& key) { return fits_in_16_bits(key, quantity); };
    return !turns_as_written(bone, quantity) && std::ranges::all_of(keys, fits);
}

/// An angle that counts modulo one turn takes the fewest bytes when it is near 0.
std::vector<std::byte> own_keys(const scene::Bone& bone, BoneQuantity quantity, Keys keys, LawTable& laws)
{
    if (quantity == BoneQuantity::angle && !bone.turns_as_written)
        for (scene::TrackKey& key : keys)
            key.value = shortest_turn({}, BinaryAngle::from_raw(key.value));
    return packed_keys(keys, false, laws);
}

class SkeletonWriter {
public:
    SkeletonWriter(const scene::Bones& skeleton, LawTable& laws) : skeleton_{skeleton}, laws_{laws}
    {
        choose_common_keys();
    }

    std::vector<std::byte> write()
    {
        ByteWriter bytes;
        bytes.u8(static_cast<std::uint32_t>(skeleton_.bones.size()));
        bytes.varint(static_cast<std::uint32_t>(common_.size()));
        bytes.append(packed(common_));
        for (const scene::Bone& bone : skeleton_.bones)
            write_bone(bone, bytes);
        return bytes.bytes();
    }

private:
    using Savings = std::map<Beats, std::ptrdiff_t>; ///< bytes

    /// Those times and laws that save most: of all quantities that have them, each stores its values only.
    void choose_common_keys()
    {
        Savings savings;
        for (const scene::Bone& bone : skeleton_.bones)
            for (std::size_t i = 0; i < bone_quantity_count; ++i)
                add_saving(bone, static_cast<BoneQuantity>(i), savings);
        std::ptrdiff_t most = 0;
        for (const auto& [beats, saved] : savings)
            if (const auto rest = saved - std::ssize(packed(beats)); rest > most) {
                most = rest;
                common_ = beats;
            }
    }

    void add_saving(const scene::Bone& bone, BoneQuantity quantity, Savings& savings)
    {
        const Keys& keys = bone.keys[static_cast<std::size_t>(quantity)];
        if (keys.empty() || !may_be_common(bone, quantity, keys))
            return;
        const auto own = std::ssize(own_keys(bone, quantity, keys, laws_));
        savings[beats_of(keys, laws_)] += std::max<std::ptrdiff_t>(own - 2 * std::ssize(keys), 0);
    }

    void write_bone(const scene::Bone& bone, ByteWriter& bytes)
    {
        bytes.u8(bone.parent ? static_cast<std::uint32_t>(*bone.parent) + 1 : 0);
        bytes.u8(flags_of(bone));
        for (const std::int32_t value : bone.set_up)
            bytes.u16(static_cast<std::uint16_t>(value));
        for (std::size_t i = 0; i < bone_quantity_count; ++i)
            if (!bone.keys[i].empty())
                write_keys(bone, static_cast<BoneQuantity>(i), bytes);
    }

    static std::uint32_t flags_of(const scene::Bone& bone)
    {
        std::uint32_t flags = bone.is_at_tip ? at_tip_bit : 0;
        for (std::size_t i = 0; i < bone_quantity_count; ++i)
            flags |= bone.keys[i].empty() ? 0 : 1U << i;
        const bool turns = !bone.keys[static_cast<std::size_t>(BoneQuantity::angle)].empty();
        return flags | (turns && bone.turns_as_written ? as_written_bit : 0);
    }

    void write_keys(const scene::Bone& bone, BoneQuantity quantity, ByteWriter& bytes)
    {
        const Keys& keys = bone.keys[static_cast<std::size_t>(quantity)];
        const std::vector<std::byte> own = own_keys(bone, quantity, keys, laws_);
        if (own.size() <= 2 * keys.size() || !may_be_common(bone, quantity, keys) ||
            beats_of(keys, laws_) != common_)
            return bytes.block(own);
        constexpr std::uint32_t common = 0;
        bytes.varint(common);
        for (const scene::TrackKey& key : keys)
            bytes.u16(static_cast<std::uint16_t>(key.value));
    }

    const scene::Bones& skeleton_;
    LawTable& laws_;
    Beats common_;
};

}

void write_bones(const std::vector<scene::Bones>& skeletons, LawTable& laws, ByteWriter& bytes)
{
    for (const scene::Bones& skeleton : skeletons)
        bytes.block(SkeletonWriter{skeleton, laws}.write());
}

}

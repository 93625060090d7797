#include "core/bone_view.hpp"

#include "core/time_code.hpp"

namespace kfast {
namespace {

constexpr std::uint32_t tip_bit = 1 << 4;
constexpr std::uint32_t as_written_bit = 1 << 5;
constexpr std::uint32_t unused_bits = 3 << 6;
constexpr std::uint32_t value_bytes = 2;

constexpr bool is_signed(BoneQuantity quantity)
{
    return quantity == BoneQuantity::x || quantity == BoneQuantity::y;
}

/// Does not add up times that have not been checked.
void skip_common_key(ByteReader& bytes)
{
    bytes.varint();
    bytes.u8();
}

std::int32_t read_value(ByteReader& bytes, bool is_signed)
{
    const std::uint32_t value = bytes.u16();
    return is_signed ? static_cast<std::int16_t>(value) : static_cast<std::int32_t>(value);
}

}

CommonKey CommonKeyCursor::next()
{
    time_ = time_ + read_time_code(bytes_);
    return {.time = time_, .laws = bytes_.u8(), .index = index_++};
}

BoneKeys BoneKeys::take(ByteReader& bytes, BoneQuantity quantity, std::uint32_t common)
{
    const std::uint32_t own = bytes.varint();
    BoneKeys keys;
    keys.kind_ = own == 0 ? Kind::common : Kind::own;
    keys.is_signed_ = is_signed(quantity);
    keys.bytes_ = bytes.take(own == 0 ? std::size_t{common} * value_bytes : own);
    return keys;
}

std::int32_t BoneKeys::common(std::uint32_t index) const
{
    ByteReader bytes = bytes_;
    bytes.skip(std::size_t{index} * value_bytes);
    return read_value(bytes, is_signed_);
}

BoneView BoneCursor::next()
{
    --left_;
    BoneView bone;
    bone.parent = bytes_.u8();
    const std::uint32_t head = bytes_.u8();
    bone.is_known = (head & unused_bits) == 0;
    bone.is_at_tip = (head & tip_bit) != 0;
    bone.turns_as_written = (head & as_written_bit) != 0;
    for (std::size_t i = 0; i < bone_quantity_count; ++i)
        bone.set_up[i] = read_value(bytes_, is_signed(static_cast<BoneQuantity>(i)));
    for (std::size_t i = 0; i < bone_quantity_count; ++i)
        if ((head & 1U << i) != 0)
            bone.keys[i] = BoneKeys::take(bytes_, static_cast<BoneQuantity>(i), common_);
    return bone;
}

BonesView::BonesView(ByteReader bytes) : count_{bytes.u8()}
{
    const std::uint32_t common = bytes.varint();
    common_ = CommonKeyCursor{bytes, common};
    for (std::uint32_t left = common; left > 0 && !bytes.overrun(); --left)
        skip_common_key(bytes);
    bones_ = bytes;
}

}

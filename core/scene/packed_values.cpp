#include "core/scene/packed_values.hpp"

namespace kfast {

PackedValues PackedValues::take(ByteReader& bytes, std::uint32_t count, std::int32_t more)
{
    PackedValues values;
    values.place_ = bytes.rest().data();
    values.more_ = static_cast<std::uint32_t>(more);
    if (count > 1) {
        const std::uint32_t form = bytes.u8();
        values.width_ = form & 31;
        values.unit_ = static_cast<std::uint8_t>(form >> 5);
    }
    values.min_ = static_cast<std::uint32_t>(bytes.signed_varint());
    values.bits_ = BitReader::take(bytes, count, values.width_);
    return values;
}

std::int32_t PackedValues::operator[](std::uint32_t index) const
{
    BitReader bits = bits_;
    bits.skip(index * width_);
    const std::int32_t stored = in_unit(min_ + bits.number(width_), unit_);
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(stored) + more_);
}

}

#include "core/scene/key_time_cursor.hpp"

#include "core/scene/kfb_limits.hpp"

namespace kfast {
namespace {

constexpr int max_law_bits = 8;
constexpr std::uint32_t input_bit = 1 << 15;

/// So that a sum does not overflow before its times are refused.
constexpr int max_time_bits = 30;
static_assert(kfb::max_time < 1 << max_time_bits);

Driver take_input(ByteReader& bytes)
{
    const Driver driver{static_cast<std::uint8_t>(bytes.u8())};
    if (driver.is_time())
        bytes.refuse();
    return driver;
}

}

KeyTimeCursor KeyTimeCursor::one()
{
    KeyTimeCursor key_times;
    key_times.count_ = 1;
    return key_times;
}

KeyTimeCursor KeyTimeCursor::take(ByteReader& bytes, const KeyTimeCursor& default_key_times)
{
    const std::byte* const place = bytes.rest().data();
    const std::uint32_t count = bytes.varint();
    if (count == 0)
        return default_key_times;
    const std::uint32_t form = bytes.u16();
    KeyTimeCursor key_times;
    key_times.place_ = place;
    key_times.count_ = count;
    key_times.time_bits_ = form & 31;
    key_times.time_shift_ = form >> 5 & 15;
    key_times.law_bits_ = form >> 9 & 63;
    if (key_times.law_bits_ > max_law_bits || key_times.time_bits_ + key_times.time_shift_ > max_time_bits) {
        bytes.refuse();
        key_times.law_bits_ = key_times.time_bits_ = key_times.time_shift_ =
            0; // whoever reads on all the same
    }
    if ((form & input_bit) != 0)
        key_times.driver_ = take_input(bytes);
    key_times.bits_ =
        BitReader::take(bytes, count, std::uint32_t{key_times.time_bits_} + key_times.law_bits_);
    return key_times;
}

void KeyTimeCursor::go_on_behind(const KeyTime& last)
{
    index_ = last.index + 1;
    time_ = last.time;
    bits_.go_to(index_ * (std::uint32_t{time_bits_} + law_bits_));
}

KeyTime KeyTimeCursor::next()
{
    const std::uint32_t bits = std::uint32_t{time_bits_} + law_bits_;
    std::uint32_t passed = 0;
    std::uint32_t laws = 0;
    if (bits <= BitReader::max) {
        const std::uint32_t both = bits_.number(bits);
        passed = both >> law_bits_;
        laws = both & ((1U << law_bits_) - 1);
    } else {
        passed = bits_.number(time_bits_);
        laws = bits_.number(law_bits_);
    }
    time_ = time_ + Time{static_cast<std::int32_t>(passed << time_shift_)};
    return {.time = time_, .laws = laws, .index = index_++};
}

}

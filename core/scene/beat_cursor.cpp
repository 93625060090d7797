#include "core/scene/beat_cursor.hpp"

#include "core/scene/kfb_limits.hpp"

namespace kfast {
namespace {

constexpr int most_law_bits = 8;
constexpr std::uint32_t input_bit = 1 << 15;

/// So that a sum does not overflow before its times are refused.
constexpr int most_time_bits = 30;
static_assert(kfb::max_time < 1 << most_time_bits);

Clock take_input(ByteReader& bytes)
{
    const Clock clock{static_cast<std::uint8_t>(bytes.u8())};
    if (clock.is_time())
        bytes.refuse();
    return clock;
}

}

BeatCursor BeatCursor::one()
{
    BeatCursor beats;
    beats.count_ = 1;
    return beats;
}

BeatCursor BeatCursor::take(ByteReader& bytes, const BeatCursor& usual)
{
    const std::byte* const place = bytes.rest().data();
    const std::uint32_t count = bytes.varint();
    if (count == 0)
        return usual;
    const std::uint32_t form = bytes.u16();
    BeatCursor beats;
    beats.place_ = place;
    beats.count_ = count;
    beats.time_bits_ = form & 31;
    beats.time_shift_ = form >> 5 & 15;
    beats.law_bits_ = form >> 9 & 63;
    if (beats.law_bits_ > most_law_bits || beats.time_bits_ + beats.time_shift_ > most_time_bits) {
        bytes.refuse();
        beats.law_bits_ = beats.time_bits_ = beats.time_shift_ = 0; // whoever reads on all the same
    }
    if ((form & input_bit) != 0)
        beats.clock_ = take_input(bytes);
    beats.bits_ = BitReader::take(bytes, count, std::uint32_t{beats.time_bits_} + beats.law_bits_);
    return beats;
}

void BeatCursor::go_on_behind(const Beat& last)
{
    index_ = last.index + 1;
    time_ = last.time;
    bits_.go_to(index_ * (std::uint32_t{time_bits_} + law_bits_));
}

Beat BeatCursor::next()
{
    const std::uint32_t bits = std::uint32_t{time_bits_} + law_bits_;
    std::uint32_t passed = 0;
    std::uint32_t laws = 0;
    if (bits <= BitReader::most) {
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

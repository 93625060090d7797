#include "core/track_view.hpp"

#include "core/time_code.hpp"

namespace kfast {
namespace {

constexpr std::uint32_t property_bits = 0x3F;
constexpr std::uint32_t smooth_bit = 0x40;
constexpr std::uint32_t fixed_bit = 0x80;

/// 2 v for v >= 0, -2 v - 1 below.
std::int32_t read_signed(ByteReader& bytes)
{
    const std::uint32_t code = bytes.varint();
    return static_cast<std::int32_t>(code >> 1 ^ (0U - (code & 1)));
}

}

TrackKey TrackKeyCursor::next()
{
    time_ = time_ + read_time_code(bytes_);
    const std::uint32_t laws = is_smooth_ ? 0 : bytes_.u8();
    return {.time = time_, .laws = laws, .value = read_signed(bytes_)};
}

TrackView TrackCursor::next()
{
    --left_;
    const std::uint32_t head = bytes_.u8();
    TrackView track;
    track.property = static_cast<Property>(head & property_bits);
    track.is_smooth = (head & smooth_bit) != 0;
    if ((head & fixed_bit) != 0) {
        track.is_fixed = true;
        track.value = read_signed(bytes_);
    } else {
        track.keys = TrackKeyCursor{bytes_.take(bytes_.varint()), track.is_smooth};
    }
    return track;
}

}

#include "core/scene/track_view.hpp"

namespace kfast {
namespace {

constexpr std::uint32_t property_bits = 0x3F;
constexpr std::uint32_t smooth_bit = 0x40;
constexpr std::uint32_t fixed_bit = 0x80;

}

TrackKey TrackKeyCursor::at(const KeyTime& key_time) const
{
    return {.time = key_time.time, .laws = is_smooth_ ? 0 : key_time.laws, .value = values_[key_time.index]};
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
        track.value = bytes_.signed_varint();
    } else {
        key_times_ = KeyTimeCursor::take(bytes_, key_times_);
        track.keys = {key_times_, PackedValues::take(bytes_, key_times_.count()), track.is_smooth};
    }
    return track;
}

}

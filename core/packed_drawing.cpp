#include "core/packed_drawing.hpp"

#include <limits>

namespace kfast {
namespace {

constexpr bool is_coordinate(std::int32_t value)
{
    return value >= std::numeric_limits<std::int16_t>::min() &&
           value <= std::numeric_limits<std::int16_t>::max();
}

}

std::uint32_t PackedDrawing::next_stroke()
{
    const std::uint32_t head = bytes_.u8();
    delta_bits_ = head & 0x1F;
    mix_ = static_cast<SegmentMix>(head >> 5 & 3);
    sound_ = sound_ && delta_bits_ <= max_delta_bits && (head >> 5) <= 2;
    const std::uint32_t segments = bytes_.varint();
    sound_ =
        sound_ && (segments == 0 || delta_bits_ != 0); // a segment costs bits, so that a count cannot lie
    at_.x = static_cast<std::int16_t>(bytes_.u16());
    at_.y = static_cast<std::int16_t>(bytes_.u16());
    start_ = checked(at_);
    pending_count_ = 0;
    pending_ = 0;
    return segments;
}

Segment PackedDrawing::next_segment()
{
    const bool cubic = mix_ == SegmentMix::cubics || (mix_ == SegmentMix::both && bits(1) != 0);
    Segment segment{.from = checked(at_)};
    const Sixteenths from = at_;
    at_ = delta_from(from);
    segment.to = checked(at_);
    if (cubic) {
        segment.kind = Segment::Kind::cubic;
        segment.c1 = checked(delta_from(from));
        segment.c2 = checked(delta_from(at_));
    }
    return segment;
}

/// The next `count` bits, lowest first, as a signed number.
std::int32_t PackedDrawing::bits(std::uint32_t count)
{
    while (pending_count_ < count) {
        pending_ |= bytes_.u8() << pending_count_;
        pending_count_ += 8;
    }
    const std::uint32_t value = pending_ & ((1U << count) - 1);
    pending_ >>= count;
    pending_count_ -= count;
    const std::uint32_t sign = count == 0 ? 0 : 1U << (count - 1);
    return static_cast<std::int32_t>((value ^ sign) - sign);
}

PackedDrawing::Sixteenths PackedDrawing::delta_from(Sixteenths origin)
{
    const std::int32_t x = bits(delta_bits_);
    return {origin.x + x, origin.y + bits(delta_bits_)};
}

Point PackedDrawing::checked(Sixteenths at)
{
    sound_ = sound_ && is_coordinate(at.x) && is_coordinate(at.y);
    return {Fixed::sixteenths(at.x), Fixed::sixteenths(at.y)};
}

PackedDrawing drawing_at(std::span<const std::byte> drawings, std::uint32_t offset)
{
    return PackedDrawing{ByteReader{drawings.subspan(offset)}};
}

}

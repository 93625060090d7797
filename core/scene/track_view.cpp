#include "core/scene/track_view.hpp"

#include "core/scene/kfb_limits.hpp"

#include <algorithm>

namespace kfast {

Time read_time_code(ByteReader& bytes)
{
    constexpr std::uint32_t beyond = kfb::max_time + 1;
    const std::uint32_t code = bytes.varint();
    const std::uint32_t number = std::min(kfb::time_code::number.get(code), beyond);
    const bool in_ticks = kfb::time_code::in_ticks.get(code);
    constexpr std::uint32_t frame = Time::ticks_per_frame;
    const std::uint32_t ticks = in_ticks ? number : std::min(number, beyond / frame + 1) * frame;
    return {static_cast<std::int32_t>(std::min(ticks, beyond))};
}

namespace {

VelocityLaw read_law(std::uint32_t kind, ByteReader& bytes)
{
    VelocityLaw law{.kind = static_cast<VelocityLaw::Kind>(kind)};
    kfb::law_pair::each_parameter(
        law, [&bytes]<class T>(T& parameter) { parameter = static_cast<T>(bytes.u16()); });
    return law;
}

}

LawPair read_law_pair(ByteReader& bytes)
{
    const std::uint32_t kinds = bytes.u8();
    const VelocityLaw x = read_law(kfb::law_pair::x.get(kinds), bytes);
    if (kfb::law_pair::y.get(kinds) == kfb::law_pair::as_for_x)
        return {x, x};
    const VelocityLaw y = read_law(kfb::law_pair::y.get(kinds), bytes);
    return {x, y};
}

namespace {

static_assert(kfb::max_time < 1 << kfb::key_times::max_time_bits);

Driver take_driver(ByteReader& bytes)
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
    if (count == kfb::key_times::use_default)
        return default_key_times;
    const std::uint32_t form = bytes.u16();
    KeyTimeCursor key_times;
    key_times.place_ = place;
    key_times.count_ = count;
    key_times.time_bits_ = static_cast<std::uint8_t>(kfb::key_times::time_width.get(form));
    key_times.time_shift_ = static_cast<std::uint8_t>(kfb::key_times::time_shift.get(form));
    key_times.law_bits_ = static_cast<std::uint8_t>(kfb::key_times::law_width.get(form));
    if (key_times.law_bits_ > kfb::key_times::max_law_width ||
        key_times.time_bits_ + key_times.time_shift_ > int{kfb::key_times::max_time_bits}) {
        bytes.refuse();
        key_times.law_bits_ = key_times.time_bits_ = key_times.time_shift_ =
            0; // for code that reads on all the same
    }
    if (kfb::key_times::has_driver.get(form))
        key_times.driver_ = take_driver(bytes);
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

TrackKey TrackKeyCursor::at(const KeyTime& key_time) const
{
    return {.time = key_time.time, .laws = is_smooth_ ? 0 : key_time.laws, .value = values_[key_time.index]};
}

TrackView TrackCursor::next()
{
    --left_;
    const std::uint32_t head = bytes_.u8();
    TrackView track;
    track.property = static_cast<Property>(kfb::track::property.get(head));
    track.is_smooth = kfb::track::is_smooth.get(head);
    if (kfb::track::is_fixed.get(head)) {
        track.is_fixed = true;
        track.value = bytes_.signed_varint();
    } else {
        key_times_ = KeyTimeCursor::take(bytes_, key_times_);
        track.keys = {key_times_, PackedValues::take(bytes_, key_times_.count()), track.is_smooth};
    }
    return track;
}

namespace {

constexpr int share_bits = 24;
constexpr int sub_bits = 8; ///< lengths are measured in 1/256 of 1/16 px

std::uint32_t total(ByteReader lengths)
{
    std::uint32_t sum = 0;
    while (lengths.left() != 0)
        sum += lengths.varint();
    return sum;
}

/// The direction of the curve at a parameter: that of the last line in de Casteljau's
/// construction; where it has no extent, at the ends, that of the next control points.
Point tangent(const Segment& segment, Fraction fraction)
{
    if (segment.kind == Segment::Kind::line)
        return segment.to - segment.from;
    const Point middle = lerp(segment.c1, segment.c2, fraction);
    const Point line = lerp(middle, lerp(segment.c2, segment.to, fraction), fraction) -
                       lerp(lerp(segment.from, segment.c1, fraction), middle, fraction);
    if (line != Point{})
        return line;
    const Point near_end =
        fraction.raw < Fraction::one / 2 ? segment.c2 - segment.from : segment.to - segment.c1;
    return near_end != Point{} ? near_end : segment.to - segment.from;
}

}

PathView PathView::take(ByteReader& bytes)
{
    ByteReader own = bytes.take(bytes.varint());
    const std::uint32_t head = own.u8();
    PathView path;
    path.turns = head != 0;
    path.is_known = head <= 1;
    path.drawing = own.varint();
    path.lengths = own;
    return path;
}

PathPlace place_on(const PathView& path, PackedDrawing stroke, std::int32_t fraction)
{
    const std::int32_t within = std::clamp<std::int32_t>(fraction, 0, 1 << share_bits);
    auto left = static_cast<std::uint32_t>(
        (std::uint64_t{total(path.lengths)} * static_cast<std::uint32_t>(within)) >> (share_bits - sub_bits));
    ByteReader lengths = path.lengths;
    std::uint32_t segments = stroke.next_stroke();
    Segment segment = stroke.next_segment();
    std::uint32_t length = lengths.varint() << sub_bits;
    while (left > length && --segments != 0) {
        left -= length;
        segment = stroke.next_segment();
        length = lengths.varint() << sub_bits;
    }
    const Fraction part = Fraction::ratio(std::min(left, length), length);
    const Point line = tangent(segment, part);
    return {point_at(segment, part), direction(line.x.raw(), line.y.raw())};
}

}

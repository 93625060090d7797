#include "core/object_view.hpp"

#include "core/kfb_limits.hpp"

#include <algorithm>

namespace kfast {
namespace {

/// Times are stored as differences: twice the frames, or twice the ticks and one. A difference beyond the
/// format's limit stays just beyond it, so that sums do not overflow before they are refused.
std::int32_t time_difference(std::uint32_t code)
{
    const std::uint32_t unit = (code & 1) != 0 ? 1 : Time::ticks_per_frame;
    const std::uint32_t limit = kfb::max_time / unit + 1;
    return static_cast<std::int32_t>(std::min(code >> 1, limit) * unit);
}

}

PackedDrawing drawing_at(std::span<const std::byte> drawings, const Key& key)
{
    ByteReader reader{drawings};
    reader.skip(key.drawing);
    return PackedDrawing{reader};
}

Key KeyCursor::next()
{
    time_ += time_difference(bytes_.varint());
    Key key{.time = {time_}};
    const std::uint32_t laws = bytes_.u8();
    key.law_x = static_cast<VelocityLaw>(laws & 15);
    key.law_y = static_cast<VelocityLaw>(laws >> 4);
    key.curve_pieces = bytes_.varint();
    key.drawing = bytes_.varint();
    return key;
}

KeyInterval ObjectView::interval_at(Time time) const
{
    KeyCursor cursor = keys;
    const Key first = cursor.next();
    KeyInterval interval{first, first};
    while (!cursor.at_end() && interval.from.time <= time) {
        interval.to = cursor.next();
        if (interval.to.time > time)
            return interval;
        interval.from = interval.to;
    }
    return {interval.from, interval.from};
}

ObjectView ObjectCursor::next()
{
    --left_;
    ObjectStyle style;
    const std::uint32_t flags = bytes_.u8();
    style.is_filled = (flags & 1) != 0;
    style.is_stroked = (flags & 2) != 0;
    style.cap = static_cast<Cap>(flags >> 2 & 3);
    style.join = static_cast<Join>(flags >> 4); // with the bits that must be 0: parse() refuses the rest
    if (style.is_filled)
        style.fill = static_cast<std::uint8_t>(bytes_.u8());
    if (style.is_stroked) {
        style.stroke = static_cast<std::uint8_t>(bytes_.u8());
        style.width = static_cast<int>(bytes_.varint());
    }
    const std::size_t key_bytes = bytes_.varint();
    const auto keys = bytes_.rest().first(key_bytes < bytes_.left() ? key_bytes : bytes_.left());
    bytes_.skip(key_bytes);
    return {style, KeyCursor{ByteReader{keys}}};
}

}

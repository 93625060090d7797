#include "core/scene/path_view.hpp"

#include <algorithm>

namespace kfast {
namespace {

constexpr int share_bits = 24;
constexpr int sub_bits = 8; ///< lengths are followed in 1/256 of 1/16 px

std::uint32_t total(ByteReader lengths)
{
    std::uint32_t sum = 0;
    while (lengths.left() != 0)
        sum += lengths.varint();
    return sum;
}

/// The direction that the curve has at a share of its parameter: that of the last line in de Casteljau's
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

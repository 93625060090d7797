#include "host/compiler/pack_drawing.hpp"

#include "core/packed_drawing.hpp"
#include "host/compiler/bit_writer.hpp"

#include <algorithm>
#include <bit>

namespace kfast {
namespace {

/// The difference of two points, in 1/16 px.
struct Delta {
    std::int32_t x;
    std::int32_t y;
};

Delta delta(scene::Point from, scene::Point to) { return {to.x - from.x, to.y - from.y}; }

/// The bits that a signed number needs.
std::uint32_t signed_bits(std::int32_t value)
{
    const auto size = static_cast<std::uint32_t>(value < 0 ? ~value : value);
    return static_cast<std::uint32_t>(std::bit_width(size)) + 1;
}

/// Calls use_segment(is it cubic) for each segment, then use_delta for its end and the control points of a
/// cubic, each from the nearer end.
template <class UseSegment, class UseDelta>
void walk(const scene::Stroke& stroke, UseSegment use_segment, UseDelta use_delta)
{
    scene::Point at = stroke.from;
    for (const scene::Segment& segment : stroke.segments) {
        use_segment(segment.cubic);
        use_delta(delta(at, segment.to));
        if (segment.cubic) {
            use_delta(delta(at, segment.c1));
            use_delta(delta(segment.to, segment.c2));
        }
        at = segment.to;
    }
}

SegmentMix mix_of(const scene::Stroke& stroke)
{
    const auto cubics = std::ranges::count_if(stroke.segments, &scene::Segment::cubic);
    if (cubics == 0)
        return SegmentMix::lines;
    return cubics == std::ssize(stroke.segments) ? SegmentMix::cubics : SegmentMix::both;
}

std::uint32_t delta_bits_of(const scene::Stroke& stroke)
{
    std::uint32_t bits = 0;
    walk(
        stroke, [](bool) {},
        [&bits](Delta step) {
            bits = std::max({bits, signed_bits(step.x), signed_bits(step.y)});
        });
    return bits;
}

void pack_stroke(const scene::Stroke& stroke, ByteWriter& bytes)
{
    const SegmentMix mix = mix_of(stroke);
    const std::uint32_t delta_bits = delta_bits_of(stroke);
    bytes.u8(static_cast<std::uint32_t>(mix) << 5 | delta_bits);
    bytes.varint(static_cast<std::uint32_t>(stroke.segments.size()));
    bytes.u16(static_cast<std::uint16_t>(stroke.from.x));
    bytes.u16(static_cast<std::uint16_t>(stroke.from.y));
    BitWriter bits{bytes};
    walk(
        stroke,
        [&](bool cubic) {
            if (mix == SegmentMix::both)
                bits.put(cubic ? 1 : 0, 1);
        },
        [&](Delta step) {
            bits.put(step.x, delta_bits);
            bits.put(step.y, delta_bits);
        });
}

}

void pack_drawing(const scene::Drawing& drawing, ByteWriter& bytes)
{
    bytes.varint(static_cast<std::uint32_t>(drawing.strokes.size()));
    for (const scene::Stroke& stroke : drawing.strokes)
        pack_stroke(stroke, bytes);
}

}

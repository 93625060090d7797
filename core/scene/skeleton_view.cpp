#include "core/scene/skeleton_view.hpp"

#include <limits>

namespace kfast {

namespace {

static_assert(kfb::bone::moved.max() == (1 << bone_quantity_count) - 1);

/// A length in 1/16 px; wraps around, does not overflow.
constexpr std::int32_t sixteenths(std::uint32_t length, bool in_pixels)
{
    return static_cast<std::int32_t>(in_pixels ? length << 4 : length);
}

}

BoneKeys BoneKeys::take(ByteReader& bytes, const KeyTimeCursor& common, std::int32_t set_up)
{
    ByteReader ahead = bytes;
    BoneKeys keys;
    keys.kind_ = ahead.u8() == kfb::key_times::use_default ? Kind::common : Kind::own;
    keys.key_times_ = KeyTimeCursor::take(bytes, common);
    keys.values_ = PackedValues::take(bytes, keys.key_times_.count(), set_up);
    return keys;
}

BoneSetUp BoneSetUp::take(ByteReader& bytes)
{
    BoneSetUp bone;
    bone.parent = bytes.u8();
    const std::uint32_t head = bytes.u8();
    bone.is_at_tip = kfb::bone::is_at_tip.get(head);
    bone.turns_as_written = kfb::bone::turns_as_written.get(head);
    bone.moved = static_cast<std::uint8_t>(kfb::bone::moved.get(head));
    const bool in_pixels = kfb::bone::in_pixels.get(head);
    const auto coordinate = [&bytes, in_pixels] {
        return sixteenths(static_cast<std::uint32_t>(bytes.signed_varint()), in_pixels);
    };
    const auto angle = static_cast<std::int32_t>(kfb::bone::is_straight.get(head) ? 0 : bytes.u16());
    const std::int32_t x = coordinate();
    const std::int32_t y = coordinate();
    bone.set_up = {angle, x, y, sixteenths(bytes.varint(), in_pixels)};
    return bone;
}

BoneView BoneCursor::next()
{
    --left_;
    BoneView bone{BoneSetUp::take(bytes_)};
    for (std::size_t i = 0; i < bone_quantity_count; ++i)
        if ((bone.moved & 1U << i) != 0)
            bone.keys[i] = BoneKeys::take(bytes_, common_, bone.set_up[i]);
    return bone;
}

SkeletonView::SkeletonView(ByteReader bytes)
    : count_{bytes.u8()}, common_{KeyTimeCursor::take(bytes, KeyTimeCursor{})}, bones_{bytes}
{
}

BackboneKeyCursor::BackboneKeyCursor(ByteReader& bytes)
    : key_times_{KeyTimeCursor::take(bytes, KeyTimeCursor::one())},
      drawings_{PackedValues::take(bytes, key_times_.count())}
{
}

BackboneKey BackboneKeyCursor::next()
{
    const KeyTime key_time = key_times_.next();
    return {.time = key_time.time,
            .laws = key_time.laws,
            .drawing = static_cast<std::uint32_t>(drawings_[key_time.index])};
}

std::size_t backbone_node_count(PackedDrawing drawing)
{
    std::size_t count = 0;
    for (std::uint32_t stroke = 0; stroke < drawing.strokes(); ++stroke) {
        const std::uint32_t segments = drawing.next_stroke();
        if (stroke % 3 == 0)
            count += segments + 2;
        for (std::uint32_t i = 0; i < segments; ++i)
            drawing.next_segment();
    }
    return count;
}

Binding::Binding(ByteReader& bytes, std::uint32_t head)
    : bytes_{bytes}, count_{kfb::skin::bones.get(head) + 1}, is_fine_{kfb::skin::has_fine_weights.get(head)}
{
    bytes.skip((is_fine_ ? 3 : 2) * (count_ - 1));
    last_ = bytes.u8();
}

SkinReader SkinReader::of(std::uint32_t bone)
{
    SkinReader reader;
    reader.binding_ = Binding{bone};
    reader.left_ = std::numeric_limits<std::uint32_t>::max();
    return reader;
}

const Binding& SkinReader::next()
{
    if (left_ != 0) {
        --left_;
        return binding_;
    }
    const std::uint32_t head = bytes_.varint();
    left_ = kfb::skin::points.get(head);
    binding_ = Binding{bytes_, head};
    return binding_;
}

}

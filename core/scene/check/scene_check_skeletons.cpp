#include "core/scene/check/scene_check.hpp"
#include "core/scene/kfb_limits.hpp"
#include "core/scene/packed_drawing.hpp"

namespace kfast {

namespace {

ValueRange range_of(BoneQuantity quantity)
{
    switch (quantity) {
    case BoneQuantity::angle:
        return {-kfb::max_bone_turn, kfb::max_bone_turn};
    case BoneQuantity::x:
    case BoneQuantity::y:
        return {kfb::min_coordinate, kfb::max_coordinate};
    case BoneQuantity::length:
        return {0, kfb::max_bone_length};
    }
    return {0, 0};
}

bool is_within(std::int32_t value, ValueRange range) { return value >= range.min && value <= range.max; }

/// Checks one skeleton.
class BoneCheck {
public:
    BoneCheck(const SceneView& scene, const SkeletonView& bones, std::uint32_t laws, ReadAllowance& allowance)
        : scene_{scene}, bones_{bones}, laws_{laws}, allowance_{allowance}
    {
    }

    bool passes() const { return check_common_keys() && check_bones(); }

private:
    bool is_key(Driver driver, Time before, Time time, std::uint32_t laws) const
    {
        return time > before && is_key_moment(scene_, driver, time) && laws <= laws_;
    }

    bool check_common_keys() const
    {
        KeyTimeCursor key_times = bones_.common_key_times();
        if (!allowance_.take(key_times.count()))
            return false;
        for (Time before{-1}; !key_times.at_end();) {
            const KeyTime key_time = key_times.next();
            if (!is_key(key_times.driver(), before, key_time.time, key_time.laws))
                return false;
            before = key_time.time;
        }
        return true;
    }

    bool check_bones() const
    {
        BoneCursor bones = bones_.bones();
        for (std::uint32_t number = 0; !bones.at_end(); ++number) {
            const BoneView bone = bones.next();
            if (bones.rest().overrun() || bone.parent > number || !check_set_up(bone) || !check_keys(bone))
                return false;
        }
        return bones.rest().left() == 0;
    }

    static bool check_set_up(const BoneView& bone)
    {
        for (std::size_t i = 0; i < bone_quantity_count; ++i)
            if (!is_within(bone.set_up[i], range_of(static_cast<BoneQuantity>(i))))
                return false;
        return bone.at_rest(BoneQuantity::length) != 0;
    }

    bool check_keys(const BoneView& bone) const
    {
        for (std::size_t i = 0; i < bone_quantity_count; ++i)
            if (bone.keys[i].kind() != BoneKeys::Kind::none &&
                !check_keys(bone.keys[i].keys(), range_of(static_cast<BoneQuantity>(i))))
                return false;
        return true;
    }

    bool check_keys(TrackKeyCursor keys, ValueRange range) const
    {
        if (keys.at_end() || !allowance_.take(keys.key_times().count()))
            return false;
        for (Time before{-1}; !keys.at_end();) {
            const TrackKey key = keys.next();
            if (!is_key(keys.key_times().driver(), before, key.time, key.laws) ||
                !is_within(key.value, range))
                return false;
            before = key.time;
        }
        return true;
    }

    const SceneView& scene_;
    const SkeletonView& bones_;
    std::uint32_t laws_;
    ReadAllowance& allowance_;
};

}

bool are_bones_valid(const SceneView& scene, std::uint32_t laws, ReadAllowance& allowance)
{
    std::uint32_t skeletons = 0;
    for (SkeletonCursor cursor = scene.skeletons(); !cursor.at_end(); ++skeletons) {
        const SkeletonView bones = cursor.next();
        if (cursor.overrun() || bones.count() == 0 || !BoneCheck{scene, bones, laws, allowance}.passes())
            return false;
    }
    return skeletons <= kfb::max_bones;
}

bool are_backbones(std::span<const std::byte> drawings, std::uint32_t offset)
{
    PackedDrawing drawing{drawings, offset};
    std::uint32_t all = 0;
    std::uint32_t nodes = 0;
    for (std::uint32_t stroke = 0; stroke < drawing.strokes(); ++stroke) {
        const std::uint32_t segments = drawing.next_stroke();
        if (stroke % 3 == 0) {
            nodes = segments;
            all += segments;
        }
        if (segments == 0 || segments != nodes)
            return false;
        for (std::uint32_t i = 0; i < segments; ++i)
            if (drawing.next_segment().kind != Segment::Kind::line)
                return false;
    }
    return drawing.strokes() != 0 && drawing.strokes() % 3 == 0 &&
           drawing.strokes() <= 3 * kfb::max_backbones && all <= kfb::max_backbone_segments;
}

bool is_built_alike(std::span<const std::byte> drawings, std::uint32_t one, std::uint32_t other)
{
    PackedDrawing a{drawings, one};
    PackedDrawing b{drawings, other};
    if (a.strokes() != b.strokes())
        return false;
    for (std::uint32_t stroke = 0; stroke < a.strokes(); ++stroke) {
        const std::uint32_t segments = a.next_stroke();
        if (b.next_stroke() != segments)
            return false;
        for (std::uint32_t i = 0; i < segments; ++i)
            if (a.next_segment().kind != b.next_segment().kind)
                return false;
    }
    return true;
}

bool has_only_lines(std::span<const std::byte> drawings, std::uint32_t offset)
{
    PackedDrawing drawing{drawings, offset};
    for (std::uint32_t stroke = 0; stroke < drawing.strokes(); ++stroke)
        for (std::uint32_t left = drawing.next_stroke(); left > 0; --left)
            if (drawing.next_segment().kind != Segment::Kind::line)
                return false;
    return true;
}

}

#include "core/bone_check.hpp"

#include "core/kfb_limits.hpp"

namespace kfast {
namespace {

ValueRange range_of(BoneQuantity quantity)
{
    switch (quantity) {
    case BoneQuantity::angle:
        return {-kfb::max_bone_turn, kfb::max_bone_turn};
    case BoneQuantity::x:
    case BoneQuantity::y:
        return {-32768, 32767};
    case BoneQuantity::length:
        return {0, 65535};
    }
    return {0, 0};
}

/// Of one skeleton.
class BoneCheck {
public:
    BoneCheck(const BonesView& bones, std::uint32_t laws) : bones_{bones}, laws_{laws} {}

    bool passes() const { return check_common_keys() && check_bones(); }

private:
    bool is_key(Time before, Time time, std::uint32_t laws) const
    {
        return time > before && time.ticks <= kfb::max_time && laws <= laws_;
    }

    bool check_common_keys() const
    {
        CommonKeyCursor keys = bones_.common_keys();
        for (Time before{-1}; !keys.at_end();) {
            const CommonKey key = keys.next();
            if (keys.rest().overrun() || !is_key(before, key.time, key.laws))
                return false;
            before = key.time;
        }
        return true;
    }

    bool check_bones() const
    {
        BoneCursor bones = bones_.bones();
        for (std::uint32_t number = 0; !bones.at_end(); ++number) {
            const BoneView bone = bones.next();
            if (bones.rest().overrun() || !bone.is_known || bone.parent > number ||
                bone.at_rest(BoneQuantity::length) == 0 || !check_keys(bone))
                return false;
        }
        return bones.rest().left() == 0;
    }

    bool check_keys(const BoneView& bone) const
    {
        for (std::size_t i = 0; i < bone_quantity_count; ++i)
            if (!check_keys(bone.keys[i], static_cast<BoneQuantity>(i), bone.turns_as_written))
                return false;
        return true;
    }

    bool check_keys(const BoneKeys& keys, BoneQuantity quantity, bool turns_as_written) const
    {
        switch (keys.kind()) {
        case BoneKeys::Kind::none:
            return true;
        case BoneKeys::Kind::common:
            return !bones_.common_keys().at_end() && !(turns_as_written && quantity == BoneQuantity::angle);
        case BoneKeys::Kind::own:
            return check_own_keys(keys.own(), range_of(quantity));
        }
        return false;
    }

    bool check_own_keys(TrackKeyCursor keys, ValueRange range) const
    {
        for (Time before{-1}; !keys.at_end();) {
            const TrackKey key = keys.next();
            if (keys.overrun() || !is_key(before, key.time, key.laws) || key.value < range.least ||
                key.value > range.most)
                return false;
            before = key.time;
        }
        return true;
    }

    const BonesView& bones_;
    std::uint32_t laws_;
};

}

bool bones_are_sound(const SceneView& scene, std::uint32_t laws)
{
    std::uint32_t skeletons = 0;
    for (BonesCursor cursor = scene.skeletons(); !cursor.at_end(); ++skeletons) {
        const BonesView bones = cursor.next();
        if (cursor.overrun() || bones.count() == 0 || !BoneCheck{bones, laws}.passes())
            return false;
    }
    return skeletons <= kfb::max_bones;
}

}

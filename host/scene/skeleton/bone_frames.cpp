#include "host/scene/skeleton/bone_frames.hpp"

#include "core/features.hpp"
#include "core/math/angle.hpp"
#include "core/time/track.hpp"
#include "host/geometry/arc.hpp"

#include <algorithm>

namespace kfast::scene {
namespace {

constexpr double units_per_pixel = 16;

std::int32_t set_up_value(const Bone& bone, BoneQuantity quantity)
{
    return bone.set_up[static_cast<std::size_t>(quantity)];
}

double way_between(const TrackKey& from, const TrackKey& to, bool is_shortest)
{
    return is_shortest ? shortest_turn(BinaryAngle::from_raw(from.value), BinaryAngle::from_raw(to.value))
                       : to.value - from.value;
}

double value_at(const Bone& bone, BoneQuantity quantity, Time time)
{
    const std::vector<TrackKey>& keys = bone.keys[static_cast<std::size_t>(quantity)];
    if (keys.empty())
        return set_up_value(bone, quantity);
    const auto to = std::ranges::upper_bound(keys, time, {}, &TrackKey::time);
    if (to == keys.begin() || to == keys.end())
        return (to == keys.begin() ? keys.front() : keys.back()).value;
    const TrackKey& from = *(to - 1);
    const ProgressXY progress = progress_between(from.time, to->time, time, from.laws, &kfast_springs);
    const Progress eased = quantity == BoneQuantity::y ? progress.y : progress.x;
    return from.value +
           way_between(from, *to, goes_the_shortest_way(bone, quantity)) * eased.raw / Progress::one;
}

template <class ValuesOf>
std::vector<BoneFrame> frames(const std::vector<Bone>& bones, ValuesOf values_of)
{
    std::vector<BoneFrame> frames;
    frames.reserve(bones.size());
    for (const Bone& bone : bones) {
        const BoneFrame parent = bone.parent ? frames[*bone.parent] : BoneFrame{};
        const double stretch = bone.parent ? lengthening_of(bones[*bone.parent], parent) : 0;
        frames.push_back(frame_in(parent, bone, values_of(bone), stretch));
    }
    return frames;
}

}

Vec2 direction_of(double angle) { return on_unit_circle(angle * 360 / BinaryAngle::turn); }

Vec2 BoneFrame::outside(Vec2 spot) const
{
    const Vec2 along = direction_of(angle);
    return origin + spot.x * along + spot.y * Vec2{-along.y, along.x};
}

Vec2 BoneFrame::inside(Vec2 spot) const
{
    const Vec2 along = direction_of(angle);
    return {dot(spot - origin, along), cross(along, spot - origin)};
}

BoneValues values_as_set_up(const Bone& bone)
{
    BoneValues values;
    std::ranges::copy(bone.set_up, values.begin());
    return values;
}

BoneValues values_at(const Bone& bone, Time time)
{
    BoneValues values;
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = value_at(bone, static_cast<BoneQuantity>(i), time);
    return values;
}

double lengthening_of(const Bone& bone, const BoneFrame& frame)
{
    return frame.length - set_up_value(bone, BoneQuantity::length) / units_per_pixel;
}

BoneFrame frame_in(const BoneFrame& parent, const Bone& bone, const BoneValues& values, double stretch)
{
    const auto [angle, x, y, length] = values;
    const Vec2 origin{x / units_per_pixel + (bone.is_at_tip ? stretch : 0), y / units_per_pixel};
    return {parent.outside(origin), parent.angle + angle, length / units_per_pixel};
}

std::vector<BoneFrame> frames_as_set_up(const std::vector<Bone>& bones)
{
    return frames(bones, values_as_set_up);
}

std::vector<BoneFrame> frames_at(const std::vector<Bone>& bones, Time time)
{
    return frames(bones, [time](const Bone& bone) { return values_at(bone, time); });
}

BoneFrame frame_at(const std::vector<Bone>& bones, std::size_t bone, Time time)
{
    const Bone& own = bones[bone];
    if (!own.parent)
        return frame_in({}, own, values_at(own, time), 0);
    const BoneFrame parent = frame_at(bones, *own.parent, time);
    return frame_in(parent, own, values_at(own, time), lengthening_of(bones[*own.parent], parent));
}

BoneMotion::BoneMotion(const BoneFrame& set_up, const BoneFrame& posed)
    : origin_{set_up.origin}, along_{direction_of(set_up.angle)}, posed_origin_{posed.origin}
{
    const Vec2 along = direction_of(posed.angle);
    posed_along_ = posed.length / set_up.length * along;
    posed_across_ = {-along.y, along.x};
}

Vec2 BoneMotion::operator()(Vec2 spot) const
{
    const Vec2 from = spot - origin_;
    return posed_origin_ + dot(from, along_) * posed_along_ + cross(along_, from) * posed_across_;
}

}

#include "host/scene/skeleton/two_bone_arm.hpp"

#include "core/math/angle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kfast::scene {
namespace {

constexpr double units_per_radian = BinaryAngle::turn / (2 * std::numbers::pi);

double angle_of(Vec2 direction) { return std::atan2(direction.y, direction.x) * units_per_radian; }

/// The angle at the origin of a triangle, of which `opposite` is the side that does not touch it. Sides that
/// do not meet are laid along each other.
double corner(double side, double other, double opposite)
{
    const double product = 2 * side * other;
    if (product == 0)
        return 0;
    const double cosine = (side * side + other * other - opposite * opposite) / product;
    return std::acos(std::clamp(cosine, -1.0, 1.0)) * units_per_radian;
}

}

Vec2 Arm::tip(double upper, double lower) const
{
    const BoneFrame upper_frame{base.origin, base.angle + upper, 0};
    return BoneFrame{upper_frame.outside(joint), upper_frame.angle + lower, lower_length}.tip();
}

Arm arm_at(const std::vector<Bone>& bones, std::size_t bone, Time time)
{
    const std::size_t upper = *bones[bone].parent;
    BoneFrame base = frame_at(bones, upper, time);
    const double stretch = play_range_of(bones[upper], base);
    base.angle -= values_at(bones[upper], time).front();
    const BoneFrame lower = frame_in({}, bones[bone], values_at(bones[bone], time), stretch);
    return {base, lower.origin, lower.length};
}

ArmAngles angles_reaching(const Arm& arm, Vec2 target, Bend bend)
{
    const double upper_length = distance({}, arm.joint);
    const double bent = corner(upper_length, distance(arm.base.origin, target), arm.lower_length);
    const double towards = angle_of(target - arm.base.origin);
    const double to_joint = towards + (bend == Bend::right ? bent : -bent);
    const double upper = to_joint - angle_of(arm.joint) - arm.base.angle;
    const Vec2 joint = arm.base.origin + upper_length * direction_of(to_joint);
    const double lower = angle_of(target - joint) - arm.base.angle - upper;
    return {upper, lower};
}

}

#pragma once

#include "core/scene/skeleton_view.hpp"
#include "core/time/time.hpp"
#include "host/geometry/outline.hpp"
#include "host/scene/model.hpp"

#include <array>
#include <cstddef>
#include <vector>

/// Where bones are on the canvas, in double precision: for what is computed before a scene is stored.
/// PosedBone of core/pose/posed_bones.hpp computes the same for pixels, in integers; the compiler's tests
/// hold them against each other.
namespace kfast::scene {

struct BoneFrame {
    Vec2 origin = {};
    double angle = 0; ///< clockwise, in 1/65536 turn
    double length = 0;

    /// Maps from the frame, x along the bone, to the canvas.
    Vec2 outside(Vec2 spot) const;
    Vec2 inside(Vec2 spot) const;
    Vec2 tip() const { return outside({length, 0}); }
};

/// The direction of an angle in 1/65536 turn.
Vec2 direction_of(double angle);

/// Indexed by BoneQuantity, in its units, but not rounded.
using BoneValues = std::array<double, bone_quantity_count>;

BoneValues values_as_set_up(const Bone& bone);
BoneValues values_at(const Bone& bone, Time time);

/// How many pixels longer than as set up `bone`, which is in `frame`, is.
double lengthening_of(const Bone& bone, const BoneFrame& frame);

/// The frame of a bone with `values` in that of its parent, which is `stretch` pixels longer than as set up.
/// That of a root's parent is the canvas: a frame at 0.
BoneFrame frame_in(const BoneFrame& parent, const Bone& bone, const BoneValues& values, double stretch);

/// The frames of all bones, in their order.
std::vector<BoneFrame> frames_as_set_up(const std::vector<Bone>& bones);
std::vector<BoneFrame> frames_at(const std::vector<Bone>& bones, Time time);
/// The frame of one bone; uses only it and its ancestors.
BoneFrame frame_at(const std::vector<Bone>& bones, std::size_t bone, Time time);

/// How a bone moves what is bound to it when it goes from `set_up` to `posed`.
class BoneMotion {
public:
    BoneMotion(const BoneFrame& set_up, const BoneFrame& posed);

    Vec2 operator()(Vec2 spot) const;

private:
    Vec2 origin_;
    Vec2 along_; ///< as set up, of length 1
    Vec2 posed_origin_;
    Vec2 posed_along_; ///< the image of along_
    Vec2 posed_across_;
};

/// Whether values of the quantity are modulo one turn.
constexpr bool goes_the_shortest_way(const Bone& bone, BoneQuantity quantity)
{
    return quantity == BoneQuantity::angle && !bone.turns_as_written;
}

}

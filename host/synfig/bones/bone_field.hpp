#pragma once

#include "host/synfig/bones/posed_rig.hpp"
#include "host/synfig/reading/layer.hpp"

#include <cstddef>
#include <map>
#include <vector>

namespace kfast::synfig {

/// The bones of a skeleton deformation, and how much each of them influences a point. Synfig's law: the
/// weight of a bone is how deep the point is in its shape (a circle about each end, and what is between them,
/// somewhat enlarged), divided by the square of the distance from the bone itself; each bone moves its
/// surroundings so that its ends at rest come to those of the pose, scaled as it is.
class BoneField {
public:
    explicit BoneField(const Layer& layer);

    std::size_t size() const { return rests_.size(); }
    const std::vector<Bone>& rests() const { return rests_; }
    /// In units of the file, y up.
    std::vector<BonePair> pairs_at(double frame) const;
    /// The weights of a point in pixels, at rest; bones that do not reach it have none.
    std::vector<art::BoneInfluence> shares(Vec2 place) const;
    /// Whether the shape of a bone contains a point in pixels.
    bool covers(Vec2 place) const;
    std::size_t nearest(Vec2 place) const;
    /// The matrix by which a bone moves what it influences, in pixels.
    art::Affine carrying(std::size_t bone, double frame) const;
    /// A point in no bone stays where it is.
    Vec2 deformed(Vec2 place, double frame) const;
    /// Whether all bones are as long as at rest, at all times, and rest at all times.
    bool keeps_lengths() const;
    /// Times that represent the motion of the bones: their waypoints, and some between.
    std::vector<double> samples() const;

private:
    Vec2 in_units(Vec2 place) const;

    const Layer& layer_;
    std::vector<Bone> rests_; ///< in units of the file
    double margin_ = 0;       ///< by how much shapes are enlarged, in units
    mutable std::map<double, std::vector<art::Affine>> carryings_;
};

}

#pragma once

#include "host/art/document/document.hpp"
#include "host/kdl/document.hpp"
#include "host/scene_text/values/writing.hpp"

#include <optional>
#include <string>
#include <vector>

namespace kfast::scene_text {

/// A bone at a time; all of its quantities have a key then.
struct BoneKey {
    double time = 0;
    double rotation = 0;
    double x = 0;
    double y = 0;
    double length = 0;
    /// The laws up to the next key; none where any law will do.
    std::optional<std::string> law = {};       ///< of rotation and length
    std::optional<std::string> place_law = {}; ///< of x and y
};

/// Whether a bone is ever longer or shorter than it is set up, by more than rounding.
bool changes_length(const art::Bone& bone);

/// The keys of a bone; none if it stays as it is set up. Where the timing of its quantities differs more than
/// a pose can express, they are linear between many keys.
std::vector<BoneKey> bone_keys(const art::Bone& bone);

struct Poses {
    std::vector<kdl::Node> nodes;
    bool turn_as_written = false; ///< the shorter way round would be a different rotation
};

/// The nodes `pose` of a skeleton. Bones that leave one time by different laws get poses of their own, a tick
/// apart.
Poses poses_of(const art::Rig& rig, const RigNames& names, std::int32_t length);

}

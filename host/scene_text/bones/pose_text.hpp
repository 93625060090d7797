#pragma once

#include "host/art/document/document.hpp"
#include "host/kdl/document.hpp"
#include "host/scene_text/values/writing.hpp"

#include <vector>

namespace kfast::scene_text {

struct Poses {
    std::vector<kdl::Node> nodes;
    bool turn_as_written = false; ///< the shortest way would lead elsewhere
};

/// The nodes `pose` of a skeleton. Bones that leave one moment by different laws get poses of their own, a
/// tick apart.
Poses poses_of(const art::Rig& rig, const RigNames& names, std::int32_t length);

}

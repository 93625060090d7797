#pragma once

#include "host/synfig/reading/layer.hpp"
#include "host/synfig/values/value.hpp"

#include <functional>
#include <string>
#include <vector>

namespace kfast::synfig {

/// A bone at rest, and the same bone as posed at one time.
struct BonePair {
    Bone rest;
    Bone pose;
};

/// What a skeleton is made of: always the same number of pairs, and the same bone at rest in each.
struct PosedBones {
    std::string name;
    std::function<std::vector<BonePair>(double)> pairs_at; ///< by frames, in units of the file
    std::vector<double> bends;                             ///< frames at which bones change their motion
};

/// A skeleton in pixels: set up as the bones are at rest, posed as they move.
struct PosedRig {
    art::Rig rig;
    std::vector<std::size_t> place; ///< of each pair: its index in the rig
};

PosedRig posed_rig(const PosedBones& bones, const Reading& reading);

}

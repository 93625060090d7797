#pragma once

#include "host/synfig/bone_field.hpp"

namespace kfast::synfig {

/// A skeleton in pixels: set up as the bones of a deformation rest, posed as they go. The bones have the
/// order of `order`, which names them by their index in the field.
struct PosedRig {
    art::Rig rig;
    std::vector<std::size_t> place; ///< of each bone of the field: its index in the rig
};

PosedRig posed_rig(const Layer& layer, const BoneField& field);

}

#pragma once

#include "host/art/document/document.hpp"

#include <optional>
#include <string>
#include <vector>

namespace kfast::scene_text {

/// A bone at a moment; all of its quantities have a key then.
struct BoneKey {
    double time = 0;
    double rotation = 0;
    double x = 0;
    double y = 0;
    double length = 0;
    /// Of the way to the next key; none where any law does.
    std::optional<std::string> law = {};       ///< of turn and length
    std::optional<std::string> place_law = {}; ///< of x and y
};

/// Whether a bone is ever longer or shorter than it is set up, by more than rounding makes of it.
bool changes_length(const art::Bone& bone);

/// The keys of a bone; none if it stays as it is set up. Where the ways of its quantities differ more than a
/// pose can say, they go straight between many keys.
std::vector<BoneKey> bone_keys(const art::Bone& bone);

}

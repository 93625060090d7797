#pragma once

#include "host/svg/poses/pose_nodes.hpp"

#include <span>
#include <string>

namespace kfast::svg {

/// What an author can do so that other parts of the drawings become each other, if any that change were found
/// by their order alone (part_match.hpp); empty if all have names in common, or the same form.
std::string match_hint(std::span<const Pose> poses);

}

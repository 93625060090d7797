#pragma once

#include "host/svg/parts/part.hpp"
#include "host/svg/poses/pose_document.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace kfast::svg {

/// The same part in one drawing after the other; null where it is not there. At least one is.
using PartLane = std::vector<const Part*>;

/// Which parts of groups that match in several drawings match each other: those with the same id, else with
/// the same label, else by their order among those of one kind, unless both have names that an author gave
/// and these differ. Groups (null: not there) and shapes never match. The first is the lowest, in the order
/// of the first drawing; what is added later is placed as it is there.
struct PartMatch {
    std::vector<PartLane> lanes;
    /// The first drawing in which their stacking order is different; 0 if there is none.
    std::size_t reordered = 0;
};
PartMatch matched(std::span<const Part* const> groups);

/// Whether an id is one that drawing programs make up: "path123", "g4-5", "Layer_1".
bool is_made_up(std::string_view id);

/// What an author can do so that other parts of the drawings become each other, if any that change were found
/// by their order alone (part_match.hpp); empty if all have names in common, or the same form.
std::string match_hint(std::span<const Pose> poses);

}

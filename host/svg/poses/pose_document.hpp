#pragma once

#include "host/art/budget.hpp"
#include "host/art/document/document.hpp"
#include "host/art/losses.hpp"
#include "host/svg/elements/part_reader.hpp"
#include "host/svg/parts/part.hpp"
#include "host/svg/poses/key_options.hpp"

#include <span>
#include <vector>

namespace kfast::svg {

/// A drawing at a time.
struct Pose {
    double time = 0;     ///< in frames
    art::Ease ease = {}; ///< of the transition to the next one
    Part root;
};

/// The nodes of a scene that looks like each of the poses at its time; there is at least one pose, and times
/// rise.
///
/// Parts that match in several poses (part_match.hpp) are one node. Groups stay groups if they fade or move,
/// or if an author has named them; all other transforms go into the points. What moves without changing its
/// form, or rotates or scales, does so as a node; what changes otherwise does so in its points.
std::vector<art::Node> nodes_of(std::span<const Pose> poses, art::Budget& budget, art::Losses& losses);

/// The scene of key drawings: of at least one pose, in the order of their times, the first at 0 or later.
art::Document document_of(const Picture& canvas, std::vector<Pose> poses, const KeyOptions& options,
                          art::Budget& budget, art::Losses& losses);

}

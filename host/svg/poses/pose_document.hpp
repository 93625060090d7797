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

/// A drawing at a moment.
struct Pose {
    double time = 0;     ///< in frames
    art::Ease ease = {}; ///< of the way to the next one
    Part root;
};

/// What a scene draws that looks like each of the poses at its time, of which there is at least one; times
/// rise.
///
/// What is the same in several poses (part_match.hpp) is one node. Groups stay groups where they fade or
/// move, or where an author has named them; all other transforms go into the points. What moves without a
/// change of its form, or turns or grows, does so as a node; what changes otherwise does so in its points.
std::vector<art::Node> nodes_of(std::span<const Pose> poses, art::Budget& budget, art::Losses& losses);

/// The scene of key drawings: of at least one pose, in the order of their times, the first at 0 or later.
art::Document document_of(const Picture& canvas, std::vector<Pose> poses, const KeyOptions& options,
                          art::Budget& budget, art::Losses& losses);

}

#pragma once

#include "host/art/budget.hpp"
#include "host/art/document/document.hpp"
#include "host/art/losses.hpp"
#include "host/svg/elements/part_reader.hpp"
#include "host/svg/poses/key_options.hpp"
#include "host/svg/poses/pose_nodes.hpp"

#include <vector>

namespace kfast::svg {

/// The scene of key drawings: of at least one pose, in the order of their times, the first at 0 or later.
art::Document document_of(const Picture& canvas, std::vector<Pose> poses, const KeyOptions& options,
                          art::Budget& budget, art::Losses& losses);

}

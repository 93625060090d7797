#pragma once

#include "host/art/losses.hpp"
#include "host/svg/poses/moments.hpp"

#include <optional>

namespace kfast::svg {

/// The shape that a shape is over all moments. Nothing where nothing of it can be seen; what lies too far
/// away to be drawn is a loss.
std::optional<art::Node> shape_node(const Moments& moments, art::Budget& budget, art::Losses& losses);

}

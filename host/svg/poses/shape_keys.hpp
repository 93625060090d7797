#pragma once

#include "host/art/losses.hpp"
#include "host/svg/poses/moments.hpp"

#include <optional>

namespace kfast::svg {

/// The node of a shape over all moments. Nothing if nothing of it is visible; what is too far away to be
/// drawn is a loss.
std::optional<art::Node> shape_node(const Moments& moments, art::Budget& budget, art::Losses& losses);

}

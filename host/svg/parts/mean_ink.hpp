#pragma once

#include "host/svg/parts/part.hpp"

#include <optional>
#include <span>

namespace kfast::svg {

/// What parts look like from far away, drawn once on each tile of an area, in their units squared: as if each
/// of them were spread evenly. Nothing where nothing is seen.
std::optional<Ink> mean_ink(std::span<const Part> parts, double tile);

}

#pragma once

#include <cstdint>

namespace kfast {

/// What the arcs at the `joins` within one flattened curve add to one piece for each, if half a turn has
/// `arc` pieces.
std::uint32_t arcs_within_curve(std::uint32_t arc, std::uint32_t joins);

}

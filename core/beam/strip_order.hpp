#pragma once

#include "core/beam/beam_lines.hpp"

#include <span>

namespace kfast {

/// Fills `legs` with all lines in the order in which their first points lie in strips across the field, to
/// the right in one and to the left in the next: a tour that is good enough for very many short lines. In
/// time n log n.
void order_by_strips(const BeamLines& lines, std::span<BeamLeg> legs);

}

#pragma once

#include "core/beam/beam_lines.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// One line of a route, and how it is followed.
struct BeamLeg {
    std::uint16_t line = 0;   ///< its number
    std::uint16_t start = 0;  ///< of a closed line: the number of its point where it begins and ends
    bool is_reversed = false; ///< from its last point to its first
};

/// Fills `legs`, which has one for each of `lines`, with the order in which they are drawn and how, so that
/// the blanked beam travels little from `from` to the first of them, between them, and back.
void find_route(const BeamLines& lines, FieldPoint from, std::span<BeamLeg> legs);

}

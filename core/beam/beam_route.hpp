#pragma once

#include "core/beam/beam_lines.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// Fills `legs` with all lines in the order in which their first points are in strips across the field, to
/// the right in one and to the left in the next: a tour that is good enough for very many short lines. In
/// time n log n.
void order_by_strips(const BeamLines& lines, std::span<BeamLeg> legs);

/// The maximum effort for a route, in travels compared.
inline constexpr std::uint32_t default_route_effort = 8192;

/// Fills `legs`, which has one for each of `lines`, with the order in which they are drawn and how, so that
/// the blanked beam travels little between them and from the last back to the first (beam_travel()): never
/// more than with all lines as they were added, each from its first point. Of this tour, which is closed, the
/// beginning is the leg that begins nearest to `from`. Returns how many travels it has compared,
/// approximately.
///
/// Takes time in proportion to n log n at most, whatever the effort, and no memory but `legs`. What comes out
/// depends on nothing but what goes in.
std::uint32_t find_route(const BeamLines& lines, FieldPoint from, std::span<BeamLeg> legs,
                         std::uint32_t effort = default_route_effort);

/// The blanked travel of the closed tour.
std::uint64_t travel_of(const BeamLines& lines, std::span<const BeamLeg> legs);

}

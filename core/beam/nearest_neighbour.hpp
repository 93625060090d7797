#pragma once

#include "core/beam/beam_lines.hpp"

#include <cstddef>
#include <span>

namespace kfast {

/// Puts `legs`, each of a line of its own, into an order in which each is the nearest one to the end of the
/// leg before it, among the first `window` of those that are left; the first one is the nearest to `from`.
/// Open lines are followed in either direction, closed ones from where they are nearest: of a long one only
/// some points are looked at.
void follow_nearest_lines(const BeamLines& lines, FieldPoint from, std::size_t window,
                          std::span<BeamLeg> legs);

/// Fills `legs` with all lines so that the lines of an item stay together, in their order or all of them
/// reversed, and each item is the nearest one to the end of the item before. Returns false, with undefined
/// `legs`, if there are more than `max_items` of them, or as many as lines.
bool follow_nearest_items(const BeamLines& lines, FieldPoint from, std::size_t max_items,
                          std::span<BeamLeg> legs);

}

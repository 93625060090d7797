#pragma once

#include "host/synfig/values/value_node.hpp"

#include <cstddef>

namespace kfast::synfig {

/// Whether values of that type go smoothly from waypoint to waypoint; others jump.
bool goes_smoothly(const Value& value);

/// On the way from one waypoint to the next, both of them constants: the share of the time is 0 to 1.
/// Between waypoints values go along cubic Hermite curves; the tangents at a waypoint follow from its
/// interpolations, its neighbours and how far away they are.
Value value_on_way(const std::vector<Waypoint>& waypoints, std::size_t index, double time);

/// The share of the way after that of the time, as the temporal tensions of both waypoints have it.
double warped_share(const Waypoint& from, const Waypoint& to, double share);

}

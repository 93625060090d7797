#pragma once

#include "host/geometry/drawing.hpp"
#include "host/geometry/outline.hpp"
#include "host/text/diagnostic.hpp"

#include <cstddef>
#include <string_view>
#include <vector>

namespace kfast::scene {

/// Reads the data of an SVG path: all commands, absolute and relative. Quadratic curves become the same
/// cubics, arcs become cubics of at most a quarter turn.
///
/// A move that nothing is drawn from gives no outline (a warning); one that is closed, or followed by a
/// segment of no length, is a single point. What is wrong goes to `findings`, with locations that count from
/// the start of `data`; reading ends at the first error, and what was read before it is returned. More than
/// `points_left` points are an error, and so is any point or control point further than `limit` pixels from
/// the origin in x or y.
std::vector<Outline> read_svg_path(std::string_view data, std::size_t points_left, Diagnostics& findings,
                                   double limit = coordinate_limit);

}

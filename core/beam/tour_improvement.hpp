#pragma once

#include "core/beam/route_effort.hpp"
#include "core/beam/tour.hpp"

#include <cstddef>

namespace kfast {

/// Makes `tour` shorter by small changes, each of which makes it shorter by itself: reverses a stretch
/// (2-opt), moves up to three legs elsewhere (Or-opt), begins closed lines at
/// other points, of which not all are looked at where there are many. Stretches and moves are at most
/// `window` legs long. Ends where no such change is left, or the effort.
void improve(Tour& tour, std::size_t window, RouteEffort& effort);

}

#pragma once

#include "core/outline_store.hpp"

namespace kfast {

/// The corner nearest to a point; halves lie lower.
constexpr Corner corner_at(Point point) { return {point.x, (point.y.raw() + 32) >> 6}; }

}

#pragma once

#include "core/math/point.hpp"

#include <cstdint>

namespace kfast {

/// A direction as a unit vector in Q15, within 1/15000 rad.
struct Direction {
    std::int32_t x = 0;
    std::int32_t y = 0;
};

/// A direction and how far it leads.
struct PolarVector {
    Direction direction;
    std::uint32_t length = 0; ///< in 1/65536 px, within 1/5000 of it
};

/// `vector` is not (0, 0).
PolarVector to_polar(Point vector);

}

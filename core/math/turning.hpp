#pragma once

#include "core/math/angle.hpp"
#include "core/math/space.hpp"

#include <cstdint>

namespace kfast {

/// How an item grows and turns about its pivot: first it grows, then it turns about z, y and x.
struct Turning {
    FineAngle x;
    FineAngle y;
    FineAngle z;
    std::int32_t scale_x = 0; ///< in 1/2^20
    std::int32_t scale_y = 0;
};

/// Where it turns about z alone. Every factor is rounded to Q16 once, as by tilted().
Space upright(const Turning& turning);
Space tilted(const Turning& turning);

}

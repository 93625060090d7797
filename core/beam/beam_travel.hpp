#pragma once

#include "core/beam/field_point.hpp"

#include <algorithm>
#include <cstdint>

namespace kfast {

/// How far a beam travels from `a` to `b`: by the longer of its two ways, as both of its mirrors, coils or
/// pairs of plates move at once.
constexpr std::int32_t beam_travel(FieldPoint a, FieldPoint b)
{
    const std::int32_t x = a.x - b.x;
    const std::int32_t y = a.y - b.y;
    return std::max(x < 0 ? -x : x, y < 0 ? -y : y);
}

}

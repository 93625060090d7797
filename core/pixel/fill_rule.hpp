#pragma once

#include <cstdint>

namespace kfast {

/// Which parts of the plane are inside of outlines that cross or enclose each other, as in SVG. The values
/// are those of the scene format.
enum class FillRule : std::uint8_t {
    nonzero,  ///< those that the outlines go around more often one way than the other
    even_odd, ///< those that the outlines go around an odd number of times
};

/// Whether what the outlines go around `winding` times is inside.
constexpr bool is_inside(FillRule rule, std::int32_t winding)
{
    return rule == FillRule::nonzero ? winding != 0 : (winding & 1) != 0;
}

}

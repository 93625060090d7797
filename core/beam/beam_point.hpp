#pragma once

#include "core/beam/field_point.hpp"
#include "core/pixel/colour.hpp"

namespace kfast {

/// Where the beam is for one tick of the point clock, and how it shines.
struct BeamPoint {
    FieldPoint at;
    Colour colour = {.opacity = 0}; ///< black with an opacity of 0 where the beam is blanked, else opaque

    constexpr bool is_lit() const { return colour.opacity != 0; }
    friend constexpr bool operator==(const BeamPoint&, const BeamPoint&) = default;
};

}

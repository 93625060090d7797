#pragma once

#include "core/beam/beam_profile.hpp"

#include <cstdint>

namespace kfast {

/// One moment of sound. The largest and the least value are the ends of what a sound card puts out.
struct StereoSample {
    std::int32_t left = 0;
    std::int32_t right = 0;

    friend constexpr bool operator==(StereoSample, StereoSample) = default;
};

/// How a sound card leads a beam: x by its left channel, y by its right one.
struct Deflection {
    bool is_swapped = false; ///< x by the right one, y by the left one
    bool inverts_x = false;
    bool inverts_y = false;
    double gain = 1; ///< at 1 the field's edges are the ends of what the sound card puts out

    /// Rounded to the nearest value. What is beyond the ends stays there.
    StereoSample sample(FieldPoint at) const;
};

}

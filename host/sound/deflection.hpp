#pragma once

#include "core/beam/beam_profile.hpp"

#include <cstdint>

namespace kfast {

/// One sample of sound. The maximum and the minimum are the ends of the output of a sound card.
struct StereoSample {
    std::int32_t left = 0;
    std::int32_t right = 0;

    friend constexpr bool operator==(StereoSample, StereoSample) = default;
};

/// How a sound card drives a beam: x by its left channel, y by its right one.
struct Deflection {
    bool is_swapped = false; ///< x by the right one, y by the left one
    bool inverts_x = false;
    bool inverts_y = false;
    double gain = 1; ///< at 1 the field's edges are the ends of the output of the sound card

    /// Rounded to the nearest value. Values beyond the ends are clamped.
    StereoSample sample(FieldPoint at) const;
};

/// An oscilloscope on a sound card, which has no input for brightness: travel is visible, so that the
/// beam travels fast, but in steps that a sound card can follow, and a dark line is one along which it is
/// fast. The rate is that of the sound.
inline constexpr BeamProfile sound_profile{.rate = 48'000,
                                           .lit_step = 655,
                                           .travel_step = 6554,
                                           .min_refresh = 30,
                                           .resolution = 256,
                                           .brightness = BeamBrightness::by_speed};

}

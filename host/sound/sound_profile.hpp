#pragma once

#include "core/beam/beam_profile.hpp"

namespace kfast {

/// An oscilloscope on a sound card, which has no input for brightness: what is travelled is seen, so that the
/// beam travels fast, but in steps that a sound card can follow, and a dark line is one along which it is
/// fast. The rate is that of the sound.
inline constexpr BeamProfile sound_profile{.rate = 48'000,
                                           .lit_step = 655,
                                           .travel_step = 6554,
                                           .min_refresh = 30,
                                           .resolution = 256,
                                           .brightness = BeamBrightness::by_speed};

}

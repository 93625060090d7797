#pragma once

#include "host/beam/beam_deflection.hpp"
#include "host/beam/phosphor.hpp"

#include <string_view>

namespace kfast {

/// What stands at the end of the beam and is no matter of the firmware: how the beam is moved, and how its
/// light looks.
struct BeamDisplay {
    std::string_view name; ///< of the ready profile that is made for it
    BeamDeflection deflection;
    double spot;      ///< how wide it is where it has half its brightness, in percent of the field's width
    double half_life; ///< milliseconds until half of the light is gone, for the phosphor and the eye together
    Phosphor phosphor;
};

/// For a ready profile (profile_choices()).
const BeamDisplay& display_of(std::string_view profile_name);

}

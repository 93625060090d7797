#pragma once

#include "core/beam/beam_profile.hpp"

#include <span>
#include <string>
#include <string_view>

namespace kfast {

/// A profile of beams that can be named on the command line and in settings.
struct ProfileChoice {
    std::string_view name;
    BeamProfile profile;
};

std::span<const ProfileChoice> profile_choices();

/// The profile that is called so. Throws Failure for a name that none has.
BeamProfile chosen_profile(const std::string& name);

}

#pragma once

#include "core/beam/beam_profile.hpp"

#include <iostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kfast {

/// A profile of beams that can be named on the command line and in settings.
struct ProfileChoice {
    std::string_view name;
    BeamProfile profile;
};

std::span<const ProfileChoice> profile_choices();
/// Returns null if none has that name.
const ProfileChoice* profile_named(std::string_view name);
/// The names of all of them, for messages.
std::vector<std::string_view> profile_names();

/// A profile, and the ready one that it is or began as.
struct ChosenBeam {
    BeamProfile profile;
    std::string_view base;
    std::string file = {}; ///< the one that describes it; empty if it is a ready one
};

/// The beam of that name, or that the file of this name describes: a name with a dot or a slash is
/// that of a file. Mistakes in a file are printed to `out`.
/// Throws Failure for a name that no profile has and for a file that describes none.
ChosenBeam chosen_beam(const std::string& name, std::ostream& out = std::cerr);
inline BeamProfile chosen_profile(const std::string& name) { return chosen_beam(name).profile; }

}

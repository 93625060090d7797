#pragma once

#include "core/beam/beam_profile.hpp"

#include <string>
#include <string_view>

namespace kfast {

/// A profile as a node that read_beam() reads as the same one, without a line end behind it: the base is the
/// ready profile that it is most like, and every property is there. All lines but the first begin with
/// `indent`.
std::string beam_text(const BeamProfile& profile, std::string_view indent = {});

}

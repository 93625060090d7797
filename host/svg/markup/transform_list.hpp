#pragma once

#include "host/art/geometry/affine.hpp"

#include <optional>
#include <string_view>

namespace kfast::svg {

/// A list of transforms of SVG or CSS: "translate(10 20) rotate(30)", "scaleX(2) rotate(0.5turn)". Nothing if
/// one of them is not in the plane, or is not valid.
std::optional<art::Affine> transform_list(std::string_view text);

}

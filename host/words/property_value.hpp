#pragma once

#include "core/pixel/paint_style.hpp"
#include "core/scene/property.hpp"

#include <string>

namespace kfast {

/// Converts what a track stores of a property (core/scene/property.hpp) to the unit that the scene language
/// has for it: pixels, degrees, or a share of 1. Not for colours, which are no numbers; `order` and `visible`
/// stay as they are.
double written_amount(Property property, double stored);

/// Returns "#rrggbb", or "#rrggbbaa" of a colour that is not opaque.
std::string colour_text(Colour colour);

}

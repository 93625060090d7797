#pragma once

#include "core/colour.hpp"
#include "core/property.hpp"

#include <string>

namespace kfast {

/// What a track stores, in the unit of the scene language: `stored` pixels, degrees, shares of 1. Not of
/// colours, nor of what jumps, which are numbers of another kind.
double written_amount(Property property, double stored);

/// "#rrggbb", with the opacity behind it unless the colour is opaque.
std::string colour_text(Colour colour);

}

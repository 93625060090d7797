#pragma once

#include "host/art/document/document.hpp"
#include "host/lottie/shapes/shapes.hpp"

namespace kfast::lottie {

/// One colour in place of a gradient.
struct MeanColour {
    art::Animated<art::Rgb> colour;
    art::Channel opacity;
};

/// Of the colours "g" of a gradient: the mean along it, as much of each colour as can be seen.
MeanColour read_mean_colour(const Json& style, const Reading& reading);

}

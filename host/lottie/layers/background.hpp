#pragma once

#include "host/art/document/document.hpp"

namespace kfast::lottie {

/// What lies lowest, is of one colour, covers the canvas and never changes is the background instead.
void lift_background(art::Document& document);

}

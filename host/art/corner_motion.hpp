#pragma once

#include "host/art/document.hpp"

namespace kfast::art {

/// By how much the tips and ends of a figure's line move, at most, when points of its drawing move by 1, at
/// any time: 1 where there are none, and more the wider the line is and the shorter its arms. Infinite where
/// an arm vanishes. All drawings must have the same form.
double corner_motion(const Figure& figure);

}

#pragma once

#include "host/art/budget.hpp"
#include "host/art/geometry/drawing.hpp"

#include <span>

namespace kfast::art {

/// Cuts the outlines of a drawing as SVG and Lottie dash lines: of the lengths in `pattern`, in pixels, the
/// first is drawn, the second left out, and so on, from the beginning again behind the last; of an odd number
/// of them, gaps and dashes change places each time. Each outline begins `offset` into the pattern. The
/// pieces are open; where a closed outline begins and ends within dashes, these are one.
///
/// Lengths are 0 or more; if all are 0, or there are none, the drawing stays whole. A dash of length 0 is a
/// single closed point, a dot if it has round or square caps. The points are taken from the budget.
Drawing dashed(const Drawing& drawing, std::span<const double> pattern, double offset, Budget& budget);

}

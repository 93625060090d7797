#pragma once

#include "host/art/document/document.hpp"

namespace kfast::art {

/// Leaves out segments of no length, makes lines of curves that are straight, and merges neighbouring
/// segments where all keys allow it. The number of segments is the same in all keys afterwards. Nothing is
/// done to a drawing whose keys have different forms, nor to one with a skin, which has weights for its
/// points.
void merge_curves(Shape& shape, double tolerance);

}

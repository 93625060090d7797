#pragma once

#include "core/math/point.hpp"

namespace kfast {

/// Where a picture stands in a larger or smaller space so that all of it is seen: centred, magnified by the
/// largest whole number that fits, or shrunk in proportion.
Rect placement(Size picture, Size space);

}

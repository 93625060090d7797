#pragma once

#include "core/math/point.hpp"

#include <cstddef>
#include <span>

namespace kfast::raster {

/// An area of a panel and what is to be seen there, row by row; every row starts on a byte.
struct Change {
    Rect area;
    std::span<const std::byte> pixels;
};

}

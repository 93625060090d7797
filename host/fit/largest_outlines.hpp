#pragma once

#include "core/raster/outline/picture.hpp"
#include "core/time/time.hpp"

#include <cstddef>
#include <cstdint>

namespace kfast::fit {

/// A picture and the object that has most of its outlines.
struct LargestOutlines {
    Time moment;
    std::size_t bytes = 0;
    std::uint32_t path = 0;     ///< of the object (core/scene/item_view.hpp)
    std::size_t item_bytes = 0; ///< of that object
};

LargestOutlines outlines_of(Time moment, const raster::Picture& picture);

}

#pragma once

#include "core/raster/outline/picture.hpp"
#include "core/time/time.hpp"
#include "host/fit/op_counts.hpp"
#include "host/fit/target.hpp"

#include <cstddef>
#include <cstdint>

namespace kfast::fit {

/// What a picture costs.
struct FrameCost {
    Time moment;
    double instructions = 0;
    double cpu_seconds = 0;
    double bus_seconds = 0;
    std::size_t areas = 0;
    std::size_t bytes = 0; ///< over the bus

    /// One band is drawn while the other is sent.
    double seconds() const { return cpu_seconds > bus_seconds ? cpu_seconds : bus_seconds; }
};

/// What the core did for a picture, and the areas and bytes that go over the bus.
struct FrameEffort {
    Time moment;
    OpCounts work;
    std::size_t areas = 0;
    std::size_t bytes = 0;
};

FrameCost cost_on(const Target& target, const FrameEffort& effort);

/// A picture and the object that has most of its outlines.
struct LargestOutlines {
    Time moment;
    std::size_t bytes = 0;
    std::uint32_t path = 0;     ///< of the object (core/scene/item_view.hpp)
    std::size_t item_bytes = 0; ///< of that object
};

LargestOutlines outlines_of(Time moment, const raster::Picture& picture);

}

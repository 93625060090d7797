#pragma once

#include "core/time/time.hpp"
#include "host/fit/op_counts.hpp"
#include "host/fit/target.hpp"

#include <cstddef>

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

}

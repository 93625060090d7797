#pragma once

#include "core/raster/outline_store.hpp"
#include "core/raster/paint_step.hpp"
#include "core/still.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast::raster {

/// A moment of a scene, ready to be drawn, in memory that the caller lends.
struct Picture {
    OutlineStore outlines;
    std::span<PaintStep> storage; ///< of the steps
    std::size_t step_count = 0;
    Still still;                 ///< of the whole scene, around the moment
    std::uint8_t coarseness = 0; ///< how often the pieces of curves were made twice as long to find room

    /// There is room for all steps that a scene needs. If two items had the same path and one were taken for
    /// the other, the last step would be lost, but no memory.
    PaintStep& add_step(const PaintStep& step)
    {
        if (step_count < storage.size())
            ++step_count;
        return storage[step_count - 1] = step;
    }

    std::span<PaintStep> steps() { return storage.first(step_count); }
    std::span<const PaintStep> steps() const { return storage.first(step_count); }
};

}

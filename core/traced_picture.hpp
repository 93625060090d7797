#pragma once

#include "core/outline_store.hpp"
#include "core/paint_step.hpp"
#include "core/still.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// A moment of a scene, ready to be swept row by row, in memory that the caller lends.
struct TracedPicture {
    OutlineStore outlines;
    std::span<PaintStep> storage; ///< of the steps
    std::size_t step_count = 0;
    Still still;                 ///< of the whole scene, around the moment
    std::uint8_t coarseness = 0; ///< how often the pieces of curves were made twice as long to find room

    std::span<PaintStep> steps() { return storage.first(step_count); }
    std::span<const PaintStep> steps() const { return storage.first(step_count); }
};

}

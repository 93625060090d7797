#pragma once

#include "core/colour.hpp"
#include "core/fill_rule.hpp"
#include "core/outline_store.hpp"

#include <cstdint>

namespace kfast {

/// Outlines that are painted together in one colour, and where a sweep of them stands.
struct Layer {
    Colour colour;
    FillRule rule = FillRule::nonzero;
    OutlineRange outlines;
    std::uint16_t waiting = 0;          ///< the first chain that the sweep has not reached
    std::uint16_t active = Chain::none; ///< chains under the sweep, from left to right
    std::int16_t row = 0;               ///< that the sweep comes to next
    std::int16_t top = 0;               ///< the first row in which there is something
    std::int16_t bottom = 0;            ///< the row below the last one
    std::int16_t left = 0;              ///< no column before it has anything
    std::int16_t right = 0;             ///< nor has this one, or one behind it

    void rewind()
    {
        waiting = outlines.first_chain;
        active = Chain::none;
        row = 0;
    }

    bool reaches(int line) const { return line >= top && line < bottom; }
};

}

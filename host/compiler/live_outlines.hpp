#pragma once

#include "core/moment.hpp"
#include "core/tracer.hpp"

#include <cstddef>

namespace kfast {

/// Corners and chains of outlines.
struct OutlineAmount {
    std::size_t corners = 0;
    std::size_t chains = 0;

    std::size_t bytes() const { return corners * sizeof(Corner) + chains * sizeof(Chain); }
    OutlineAmount& operator+=(const OutlineAmount& other)
    {
        corners += other.corners;
        chains += other.chains;
        return *this;
    }
};

/// What the outlines of all live drawings that are seen at `moment` take at most, whatever is told.
OutlineAmount live_outlines(const SceneOnPanel& on_panel, const Moment& moment);

}

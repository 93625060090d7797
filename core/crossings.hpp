#pragma once

#include "core/fixed.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace kfast {

/// Where a border of what is filled runs through a row.
struct Crossing {
    Fixed top;            ///< x at the upper border of the row; of a bent one the leftmost x
    Fixed bottom;         ///< x at the lower border; the rightmost one
    bool is_bent = false; ///< it is not straight

    Fixed left() const { return std::min(top, bottom); }
    Fixed right() const { return std::max(top, bottom); }

    friend bool operator==(const Crossing&, const Crossing&) = default;
};

/// The borders in a row, from left to right, none touching the next.
struct Crossings {
    static constexpr std::size_t most = 12;

    std::size_t count = 0; ///< in front: small processors reach it in fewer steps
    std::array<Crossing, most> borders;

    void add(Fixed top, Fixed bottom, bool is_bent)
    {
        Crossing& added = borders[count++]; // one after the other: a whole one is copied by a call
        added.top = top;
        added.bottom = bottom;
        added.is_bent = is_bent;
    }

    std::span<const Crossing> list() const { return std::span{borders}.first(count); }
};

}

#pragma once

#include "core/coverage_row.hpp"
#include "core/layer.hpp"
#include "core/outline_store.hpp"
#include "core/row_parts.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace kfast {

/// Makes a layer of outlines that are in `store`, ready to be swept.
Layer layer_of(OutlineStore& store, const OutlineRange& outlines);

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
    static constexpr std::size_t most = RowParts::most;

    std::array<Crossing, most> borders;
    std::size_t count = 0;

    void add(Fixed top, Fixed bottom, bool is_bent)
    {
        Crossing& added = borders[count++]; // one after the other: a whole one is copied by a call
        added.top = top;
        added.bottom = bottom;
        added.is_bent = is_bent;
    }

    std::span<const Crossing> list() const { return std::span{borders}.first(count); }
};

/// Sweeps one row. If borders run through all of it without touching each other, it tells where and returns
/// true. What they enclose, by the fill rule of the layer, is added to `coverage`, which is empty; this is
/// left out if they run through and `wants_coverage` is false.
///
/// Areas are exact, but for a slight bend within a row, up to 7 degrees where the edge is upright: its chord
/// stands for it there, which is off by 1/64 of a pixel's area at most.
///
/// Rows may come in any order; from one to the next below it is cheap.
bool sweep_row(OutlineStore& store, Layer& layer, int row, CoverageRow& coverage, Crossings& crossings,
               bool wants_coverage);

/// Adds what the layer encloses in a row to `coverage`, which is empty.
void sweep_row(OutlineStore& store, Layer& layer, int row, CoverageRow& coverage);

}

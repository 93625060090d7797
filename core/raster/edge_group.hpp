#pragma once

#include "core/pixel/paint_style.hpp"
#include "core/raster/coverage.hpp"
#include "core/raster/row_chain.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast::raster {

/// Adds the areas of a chain of a row.
void add_chain(const RowChain& chain, int columns, CoverageSums& sums);

/// The maximum number of chains that add_group() takes: they have room in one part of a line.
inline constexpr std::size_t max_group = SampleLine::max_count;

/// Adds the areas of chains of a layer that share pixels in a row, and of no others; `winding` is that to the
/// left of them. Their order changes. Returns that to the right of them.
///
/// Sums of areas give the coverage as long as windings go no further than from 0 to 1, or never to 0. Where
/// they do, as where two outlines overlap within a pixel, only edges between inside and outside are added:
///
///     windings     0 | 1 | 2 | 1 | 0
///     added          +           -
///
/// Straight edges that cross in the row are cut there; among others, 8 lines through the row determine which
/// these are.
std::int32_t add_group(std::span<RowChain> chains, FillRule rule, std::int32_t winding, int columns,
                       CoverageSums& sums);

/// From a column on, only whether it is inside counts, not how often outlines go around it; end_inside()
/// undoes that from a column on.
void begin_inside(int column, FillRule rule, std::int32_t winding, int columns, CoverageSums& sums);
void end_inside(int column, FillRule rule, std::int32_t winding, int columns, CoverageSums& sums);

}

#pragma once

#include "core/coverage_row.hpp"
#include "core/crossings.hpp"
#include "core/layer.hpp"
#include "core/outline_store.hpp"

namespace kfast {

/// Makes a layer of outlines that are in `store`, ready to be swept.
Layer layer_of(OutlineStore& store, const OutlineRange& outlines);

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

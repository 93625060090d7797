#pragma once

#include "core/coverage_row.hpp"
#include "core/layer.hpp"
#include "core/outline_store.hpp"

namespace kfast {

/// Makes a layer of outlines that are in `store`, ready to be swept.
Layer layer_of(OutlineStore& store, const OutlineRange& outlines);

/// Adds what the outlines of `layer` enclose in one row, by its fill rule, to `coverage`, which is empty.
/// Rows may come in any order; from one to the next below it is cheap.
void sweep_row(OutlineStore& store, Layer& layer, int row, CoverageRow& coverage);

}

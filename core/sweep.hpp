#pragma once

#include "core/coverage_row.hpp"
#include "core/edge_list.hpp"

namespace kfast {

/// Moves the sweep of `layer` over one row and adds what its edges enclose, by its fill rule, to
/// `coverage`. Rows are swept from 0 downwards, each once.
void sweep_row(EdgeList& edges, Layer& layer, int row, CoverageRow& coverage);

}

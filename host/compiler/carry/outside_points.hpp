#pragma once

#include "host/compiler/carry/backbone_cells.hpp"
#include "host/scene/model.hpp"
#include "host/text/diagnostic.hpp"

namespace kfast {

/// Warns of the points of a key's drawing that lie in none of `cells`, which are those at its time. What is
/// less than 1/8 px outside, as rounding makes it, does not count.
void warn_of_outside_points(const scene::Key& key, const BackboneCells& cells, Diagnostics& diagnostics);

}

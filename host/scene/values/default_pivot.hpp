#pragma once

#include "host/scene/model.hpp"
#include "host/scene/values/item_values.hpp"

#include <vector>

namespace kfast::scene {

/// What `values` do not say of the pivot: the centre of the box of the vertices of the first drawing that is
/// not empty, rounded to 1/16 px, halves up. Control points do not count.
void set_default_pivot(const std::vector<Key>& keys, ItemValues& values);
/// Likewise: this point.
void set_default_pivot(Point pivot, ItemValues& values);

}

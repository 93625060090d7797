#pragma once

#include "host/compiler/item_writer.hpp"
#include "host/scene/model.hpp"
#include "host/text/diagnostic.hpp"

namespace kfast {

/// Checks what the format limits of a whole scene: items, tracks, and points in all keys together. Too much
/// of any is an error at the item with the largest share.
void check_allowances(const scene::Scene& scene, const PointsOfObjects& points, Diagnostics& diagnostics);

}

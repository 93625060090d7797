#pragma once

#include "host/scene/model.hpp"

#include <vector>

namespace kfast::scene {

/// Whether every key that draws something draws pies alone, so that an object is trimmed by their angles.
bool are_pies(const std::vector<Key>& keys);

/// The track of an object that is trimmed by the angles of its pies.
Track trim_by_angles();

/// Replaces arcs of circles, or pies, whose angles change from key to key: each key draws all that any of
/// them reaches, and the tracks that are returned say from which angle to which. So an end runs along its
/// circle, where its points alone would go straight. Nothing is replaced, and there are no tracks, if the
/// keys draw anything else beside, or if an arc changes its direction and reaches further than one turn.
std::vector<Track> trim_sectors(std::vector<Key>& keys, Driver driver);

}

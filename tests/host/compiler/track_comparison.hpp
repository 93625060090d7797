#pragma once

#include "core/scene/scene_view.hpp"
#include "host/scene/model.hpp"

namespace kfast::test {

/// A track that is not stored must be one that changes nothing.
void compare_tracks(const SceneView& view, TrackCursor cursor, const scene::Item& item);

}

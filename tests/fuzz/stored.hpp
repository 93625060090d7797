#pragma once

#include "core/scene/scene_view.hpp"

namespace kfast::test {

/// Reads everything that a scene stores, items that are hidden or used nowhere too, and demands what parse()
/// promises of it.
void read_all(const SceneView& scene);

}

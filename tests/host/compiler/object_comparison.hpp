#pragma once

#include "core/scene/scene_view.hpp"
#include "host/scene/model.hpp"

namespace kfast::test {

/// What is painted by `read` is what was written: a drawing, a text or what is told.
void compare_object(const SceneView& view, const ItemView& read, const scene::Object& object);

}

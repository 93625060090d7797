#pragma once

#include "host/scene/context/scene_context.hpp"
#include "host/scene/model.hpp"

#include <vector>

namespace kfast::scene {

/// Warns of an object at `place` whose points have found their bones by the regions of these, if some follow
/// two bones alike that lie on each other as set up and then move apart: neither carries them. `bindings` are
/// those of its points as `weights` counts them.
void warn_of_overlapping_bones(const std::vector<Bone>& bones, const std::vector<Binding>& bindings,
                               SourceSpan place, SceneContext& context);

}

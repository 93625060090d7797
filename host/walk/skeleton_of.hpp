#pragma once

#include "core/scene/scene_view.hpp"

#include <cstdint>

namespace kfast {

/// The skeleton of this number, which objects name that it carries.
inline SkeletonView skeleton_of(const SceneView& scene, std::uint32_t number)
{
    SkeletonCursor skeletons = scene.skeletons();
    for (; number > 0; --number)
        skeletons.skip();
    return skeletons.next();
}

}

#pragma once

#include "core/scene/scene_view.hpp"
#include "tests/core/raw_scene.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

/// Whether parse() takes the scene; if not, because of something within it.
inline bool is_accepted(const RawScene& scene)
{
    const Bytes file = scene.file();
    const auto view = SceneView::parse(file);
    if (!view)
        CHECK(view.error() == Error::bad_scene);
    return static_cast<bool>(view);
}

inline bool takes_items(const Bytes& items)
{
    RawScene scene;
    scene.items = items;
    return is_accepted(scene);
}

}

#pragma once

#include "core/scene/scene_view.hpp"

#include <cstddef>
#include <vector>

namespace kfast {

/// An object that the pictures of a scene show nothing of.
struct UnseenObject {
    std::size_t number = 0; ///< its place in SceneFile::item_names
    bool is_hidden = false; ///< or transparent, all the time; else outside of the canvas, or without area
};

/// Those of a scene on a panel of the size of its canvas, in each frame of it with its inputs as they usually
/// are; and, with one after the other of them at all of its keys and halfway between them, at the moments of
/// all keys and halfway between those. What shows a text or a drawing from outside is none, for it may be
/// told one. Nothing is found where that takes too long: in scenes with more than 5,000 frames, or fewer if
/// they have many drawings or inputs.
std::vector<UnseenObject> unseen_objects(const SceneView& scene);

}

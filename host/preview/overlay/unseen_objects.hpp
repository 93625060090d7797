#pragma once

#include "core/scene/scene_view.hpp"

#include <cstddef>
#include <vector>

namespace kfast {

/// An object that is not visible in any picture of a scene.
struct UnseenObject {
    std::size_t number = 0; ///< its number in SceneFile::item_names
    bool is_hidden = false; ///< or transparent, all the time; else outside of the canvas, or without area
};

/// The unseen objects of a scene on a panel of the size of its canvas, in each frame with its inputs at their
/// defaults; and, with one after the other of them at all of its keys and halfway between them, at the times
/// of all keys and halfway between those. Objects that show a text or a drawing from outside are not
/// reported, as it may be set. Nothing is found where that takes too long: in scenes with more than 5,000
/// frames, or fewer if they have many drawings or inputs.
std::vector<UnseenObject> unseen_objects(const SceneView& scene);

}

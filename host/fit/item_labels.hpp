#pragma once

#include "core/scene/scene_view.hpp"
#include "host/walk/stored_items.hpp"

#include <cstdint>
#include <map>
#include <span>
#include <string>

namespace kfast::fit {

/// What the objects of a scene are called, by their paths (core/scene/item_view.hpp).
class ItemLabels {
public:
    /// `names` are those of the items in the order in which the scene stores them, or none.
    ItemLabels(const SceneView& scene, std::span<const std::string> names);

    /// "gaze/left-eye/shape"; "object 3" if it has no name, "" if there is no such object.
    std::string operator[](std::uint32_t path) const;

private:
    struct Outer {
        std::uint32_t path = 0;
        std::string label;
    };

    void add(ItemCursor items, const Outer& outer);

    const SceneView& scene_;
    std::map<const std::byte*, StoredItem> items_;
    std::map<std::uint32_t, std::string> labels_; ///< by the paths of objects
};

}

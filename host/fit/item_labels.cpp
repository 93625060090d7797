#include "host/fit/item_labels.hpp"

#include "core/item_path.hpp"
#include "host/every_item.hpp"

namespace kfast::fit {

ItemLabels::ItemLabels(const SceneView& scene, std::span<const std::string> names) : scene_{scene}
{
    std::size_t objects = 0;
    every_item(scene, [&](const ItemView& item) {
        std::string& name = names_[item.place];
        if (!names.empty()) {
            name = names.front();
            names = names.subspan(1);
        }
        if (!item.is_leaf())
            return;
        ++objects;
        if (name.empty())
            name = "object " + std::to_string(objects);
    });
    add(scene.items(), {});
}

void ItemLabels::add(ItemCursor items, const Outer& outer)
{
    while (!items.at_end()) {
        const ItemView item = items.next();
        Outer inner{path_to(item, outer.path, scene_), outer.label};
        const std::string& name = names_.at(item.place);
        if (!name.empty())
            inner.label += (inner.label.empty() ? "" : "/") + name;
        if (item.is_leaf())
            labels_[inner.path] = inner.label;
        else
            add(scene_.items_in(item), inner);
    }
}

std::string ItemLabels::operator[](std::uint32_t path) const
{
    const auto label = labels_.find(path);
    return label == labels_.end() ? "" : label->second;
}

}

#include "host/fit/item_labels.hpp"

#include "core/scene/item_view.hpp"

namespace kfast::fit {

ItemLabels::ItemLabels(const SceneView& scene, std::span<const std::string> names)
    : scene_{scene}, items_{stored_items(scene, names)}
{
    add(scene.items(), {});
}

void ItemLabels::add(ItemCursor items, const Outer& outer)
{
    while (!items.at_end()) {
        const ItemView item = items.next();
        Outer inner{path_to(scene_.place_of(item.place), outer.path), outer.label};
        const std::string& name = items_.at(item.place).name;
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

#include "host/preview/posed_scene.hpp"

#include "core/item_path.hpp"
#include "core/item_state.hpp"
#include "core/opacity.hpp"
#include "core/paint_order.hpp"

#include <algorithm>

namespace kfast {

PosedScene::PosedScene(const SceneView& scene, Size panel, Fit fit)
    : WordBlock{bytes_for(scene)}, LiveScene{scene, panel, fit, bytes()}, items_{stored_items(scene, {})}
{
}

Moment PosedScene::at(Time moment) { return pose(std::clamp(moment, Time{}, scene().length())); }

std::optional<ItemView> PosedScene::item(std::size_t number) const
{
    std::optional<ItemView> found;
    every_item(scene(), [&](const ItemView& item) {
        if (number-- == 0)
            found = item;
    });
    return found;
}

void PosedScene::visit(Time moment, const Visit& visit)
{
    const Moment posed = at(moment);
    Walk walk{posed, visit, {}};
    this->visit(scene().items(), {on_panel().canvas}, walk);
}

void PosedScene::visit(ItemCursor items, const Outer& outer, Walk& walk)
{
    PaintOrder order{items, walk.moment};
    while (const auto item = order.next()) {
        walk.numbers.push_back(items_.at(item->place).number);
        visit(*item, outer, walk);
        walk.numbers.pop_back();
    }
}

/// As Tracer does.
void PosedScene::visit(const ItemView& item, const Outer& outer, Walk& walk)
{
    const ItemState state{scene(), item, walk.moment};
    Outer inner{outer.space, path_to(item, outer.path, scene()),
                product_of_opacities(outer.opacity, state.opacity())};
    if (inner.opacity == 0)
        return;
    if (!item.tracks.at_end())
        inner.space = outer.space * state.placement();
    if (item.is_leaf())
        walk.visit({item, inner.space, walk.moment, inner.path, walk.numbers});
    else
        visit(scene().items_in(item), inner, walk);
}

}

#include "host/preview/overlay/posed_scene.hpp"

#include "core/scene_walk.hpp"

#include <algorithm>
#include <vector>

namespace kfast {

PosedScene::PosedScene(const SceneView& scene, Size panel, Fit fit)
    : WordBlock{bytes_for(scene)}, SceneState{scene, panel, fit, bytes()}, items_{stored_items(scene, {})}
{
}

SceneTime PosedScene::at(Time moment) { return pose(std::clamp(moment, Time{}, scene().length())); }

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
    const SceneTime posed = at(moment);
    SceneWalk walk{on_panel(), SceneWalk::Opacity::of_leaves};
    while (walk.next() == SceneWalk::Step::leaf) {
        std::vector<std::size_t> numbers;
        for (std::size_t level = 0; level < walk.depth(); ++level)
            numbers.push_back(items_.at(scene().at(walk.node(level).place).rest().data()).number);
        visit({item_view(scene(), walk.node()), walk.node(), walk.space(), posed, walk.path(), numbers});
    }
}

}

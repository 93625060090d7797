#include "host/art/prepare/shared_eases.hpp"

#include "host/art/document/every_animation.hpp"

#include <array>
#include <cmath>
#include <set>
#include <string>
#include <tuple>

namespace kfast::art {
namespace {

/// Parts of 1 to which controls are rounded, the finest first; that of the scene language is none, for it
/// loses nothing.
constexpr std::array grids{8192.0, 128.0, 64.0, 32.0, 16.0, 8.0, 4.0, 2.0};

Ease rounded(const Ease& ease, double grid)
{
    const auto near = [grid](double control) { return std::round(control * grid) / grid; };
    return {ease.kind, near(ease.x1), near(ease.y1), near(ease.x2), near(ease.y2)};
}

template <typename Visit>
void every_ease(Document& document, Visit&& visit)
{
    const auto look_at = [&](auto& animated) {
        for (auto& key : animated.keys)
            if (key.ease.kind == EaseKind::cubic)
                visit(key.ease);
    };
    every_node(document.nodes, [&](Node& node, const std::string&) {
        every_animation(node.transform, look_at);
        look_at(node.opacity);
        if (auto* shape = std::get_if<Shape>(&node.content))
            every_animation(*shape, look_at);
    });
    for (Rig& rig : document.rigs)
        for (Bone& bone : rig.bones)
            every_animation(bone, look_at);
}

std::size_t different_eases(Document& document, double grid)
{
    std::set<std::tuple<double, double, double, double>> found;
    every_ease(document, [&](const Ease& ease) {
        const Ease near = rounded(ease, grid);
        found.emplace(near.x1, near.y1, near.x2, near.y2);
    });
    return found.size();
}

}

void share_eases(Document& document, Losses& losses)
{
    const std::size_t before = different_eases(document, grids.front());
    if (before <= max_eases)
        return;
    double grid = 0;
    std::size_t after = before;
    for (std::size_t i = 1; i < grids.size() && after > max_eases; ++i) {
        grid = grids[i];
        after = different_eases(document, grid);
    }
    every_ease(document, [grid](Ease& ease) { ease = rounded(ease, grid); });
    losses.add({std::to_string(before) + " different eases", "", std::nullopt,
                std::to_string(after) + " of them, each near to those that it replaces"});
}

}

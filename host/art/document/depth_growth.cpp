#include "host/art/document/depth_growth.hpp"

#include <algorithm>
#include <cmath>

namespace kfast::art {
namespace {

bool has_depth(const std::vector<Node>& nodes)
{
    return std::ranges::any_of(nodes, [](const Node& node) {
        const Transform& transform = node.transform;
        for (const Channel* channel : {&transform.z, &transform.rotate_x, &transform.rotate_y})
            if (greatest(*channel) > 0)
                return true;
        const auto* group = std::get_if<Group>(&node.content);
        return group && has_depth(group->nodes);
    });
}

double farthest(Range range, double from)
{
    return std::max(std::abs(range.low - from), std::abs(range.high - from));
}

}

bool has_depth(const Document& document) { return has_depth(document.nodes); }

double perspective_scale_factor(const Document& document, const Extent& all)
{
    if (all.empty() || !has_depth(document))
        return 1;
    // As docs/scene-language.md has it: seen camera / (camera - z) times as large, and no nearer than that.
    constexpr double nearest = 15.0 / 16;
    const double camera = document.camera.value_or(2 * std::max(document.width, document.height));
    const double scale_factor = camera / (camera - std::clamp(all.z.high, 0.0, nearest * camera));
    const double away = std::hypot(farthest(all.x, document.width / 2), farthest(all.y, document.height / 2));
    // A motion across the canvas grows by that; one towards the viewer moves what is far from the middle.
    return scale_factor * (1 + away * scale_factor / camera);
}

}

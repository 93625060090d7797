#include "host/scene_text/arrange/camera.hpp"

#include "core/scene/kfb_limits.hpp"
#include "host/scene_text/arrange/placement.hpp"

#include <algorithm>
#include <cmath>

namespace kfast::scene_text {
namespace {

bool has_depth(const std::vector<art::Node>& nodes)
{
    return std::ranges::any_of(nodes, [](const art::Node& node) {
        const auto* const group = std::get_if<art::Group>(&node.content);
        return !lies_flat(node.transform) || node.transform.z != art::Channel{0} ||
               (group != nullptr && has_depth(group->nodes));
    });
}

}

std::optional<std::size_t> camera_of(const art::Document& document)
{
    if (!has_depth(document.nodes))
        return std::nullopt;
    const double distance = document.camera.value_or(kfb::max_camera);
    return static_cast<std::size_t>(
        std::clamp<double>(std::round(distance), kfb::min_camera, kfb::max_camera));
}

}

#include "host/lottie/layers/camera.hpp"

#include "host/lottie/layers/layer.hpp"
#include "host/lottie/shapes/transform.hpp"

#include <cmath>

namespace kfast::lottie {
namespace {

constexpr double nearly = 0.01;

/// Of what always has the same value; nothing of others.
std::optional<double> still(const Json& ks, const char* name, std::size_t index, double default_value,
                            Animation& animation)
{
    return steady_value(read_channel(ks, name, index, default_value, 1, {}, animation.budget));
}

bool is_at(const Json& ks, const char* name, std::size_t index, double value, Animation& animation)
{
    const auto found = still(ks, name, index, value, animation);
    return found && std::abs(*found - value) <= nearly;
}

bool looks_straight(const Json& camera, double distance, Animation& animation)
{
    const Json* const ks = find_member(camera, "ks");
    if (!ks || find_member(camera, "parent"))
        return false;
    const double x = animation.width / 2;
    const double y = animation.height / 2;
    for (const char* const turn : {"rx", "ry", "rz", "r"})
        if (!is_at(*ks, turn, 0, 0, animation))
            return false;
    for (const std::size_t axis : {0U, 1U, 2U})
        if (!is_at(*ks, "or", axis, 0, animation))
            return false;
    return is_at(*ks, "p", 0, x, animation) && is_at(*ks, "p", 1, y, animation) &&
           is_at(*ks, "p", 2, -distance, animation) && is_at(*ks, "a", 0, x, animation) &&
           is_at(*ks, "a", 1, y, animation);
}

}

std::optional<double> read_camera(Animation& animation)
{
    const Json& layers = array_at(animation.root, "layers");
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const Json& layer = layers[i];
        if (!layer.is_object() || kind_of(layer) != LayerKind::camera || truth_at(layer, "hd", false))
            continue;
        const art::Channel distance = read_channel(layer, "pe", 0, 0, 1, {}, animation.budget);
        const double first = distance.keys.front().value;
        if (!steady_value(distance) || !looks_straight(layer, first, animation))
            animation.losses.add({"camera", name_of(layer, i), std::nullopt,
                                  "one that stands still and looks at the middle of the canvas"});
        if (first > 0)
            return first;
    }
    return std::nullopt;
}

}

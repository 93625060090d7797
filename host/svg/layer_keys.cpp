#include "host/svg/layer_keys.hpp"

#include "host/failure.hpp"
#include "host/svg/layer_time.hpp"
#include "host/svg/svg_text.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

namespace kfast::svg {
namespace {

/// Inkscape's label; of other programs, the id.
std::string layer_name(pugi::xml_node element)
{
    const auto label = element.attribute("inkscape:label");
    return label ? label.value() : element.attribute("id").value();
}

std::vector<KeyLayer> timed_layers(pugi::xml_node root, double frame_rate)
{
    std::vector<KeyLayer> layers;
    for (const pugi::xml_node child : root.children()) {
        if (element_name(child) != "g")
            continue;
        const std::string name = layer_name(child);
        if (const auto time = layer_time(name, frame_rate))
            layers.push_back({child, name, *time});
    }
    std::ranges::stable_sort(layers, {}, &KeyLayer::time);
    return layers;
}

/// Ids are unique in a text, so that those of a copied layer differ from the ones it was copied from.
void forget_ids(Part& part)
{
    part.id.clear();
    for (Part& inner : part.parts)
        forget_ids(inner);
}

const KeyLayer* layer_of(const Part& part, const std::vector<KeyLayer>& layers)
{
    const auto found = std::ranges::find_if(layers, [&](const KeyLayer& layer) {
        return part.is_group && (part.label.empty() ? part.id : part.label) == layer.name;
    });
    return found == layers.end() ? nullptr : &*found;
}

}

std::vector<KeyLayer> key_layers(pugi::xml_node root, const KeyOptions& options)
{
    if (options.layers == LayerKeys::never)
        return {};
    auto layers = timed_layers(root, options.frame_rate);
    if (layers.size() < 2) {
        if (options.layers == LayerKeys::always)
            throw Failure(
                "no two layers are named by a frame: name them \"0\", \"12\", \"frame 24\" or \"0.5s\"");
        return {};
    }
    const auto same = std::ranges::adjacent_find(layers, {}, &KeyLayer::time);
    if (same != layers.end())
        throw Failure("the layers \"" + same->name + "\" and \"" + std::next(same)->name +
                      "\" are named by the same frame: rename one of them");
    return layers;
}

std::vector<Pose> poses_of(const Part& root, const std::vector<KeyLayer>& layers, const KeyOptions& options)
{
    std::vector<Pose> poses;
    for (const KeyLayer& layer : layers) {
        Pose pose{layer.time, options.ease, root};
        pose.root.parts.clear();
        Part key;
        key.is_group = true;
        key.kind = "g";
        std::size_t place = root.parts.size();
        for (const Part& part : root.parts) {
            const KeyLayer* const of_layer = layer_of(part, layers);
            if (of_layer == nullptr) {
                pose.root.parts.push_back(part);
                continue;
            }
            place = std::min(place, pose.root.parts.size());
            if (of_layer == &layer)
                key = part;
        }
        forget_ids(key);
        key.label.clear();
        key.name.clear();
        pose.root.parts.insert(pose.root.parts.begin() + static_cast<std::ptrdiff_t>(place), std::move(key));
        poses.push_back(std::move(pose));
    }
    return poses;
}

}

#include "host/svg/poses/layer_keys.hpp"

#include "host/geometry/path_scanner.hpp"
#include "host/program/failure.hpp"
#include "host/svg/markup/length.hpp"
#include "host/svg/markup/svg_text.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace kfast::svg {

namespace {

bool take(std::string_view& text, std::string_view beginning)
{
    const bool found =
        text.size() >= beginning.size() &&
        std::ranges::equal(text.substr(0, beginning.size()), beginning, [](char one, char other) {
            return (one >= 'A' && one <= 'Z' ? one - 'A' + 'a' : one) == other;
        });
    if (found)
        text = trimmed(text.substr(beginning.size()));
    return found;
}

/// Frames in a unit of time.
std::optional<double> frames_in(std::string_view unit, double frame_rate)
{
    if (unit == "s")
        return frame_rate;
    if (unit == "ms")
        return frame_rate / 1000;
    return unit.empty() ? std::optional{1.0} : std::nullopt;
}

}

std::optional<double> layer_time(std::string_view name, double frame_rate)
{
    std::string_view text = trimmed(name);
    std::optional<double> unit;
    if (take(text, "(s)"))
        unit = frame_rate;
    else if (take(text, "(ms)"))
        unit = frame_rate / 1000;
    else if (take(text, "frame") || take(text, "f"))
        unit = 1;
    scene::PathScanner scanner{text};
    const auto value = scanner.number();
    if (!value || *value < 0)
        return std::nullopt;
    const std::string_view rest = trimmed(text.substr(scanner.offset()));
    const std::string_view behind = trimmed(rest.substr(0, std::min(rest.find(':'), rest.size())));
    if (!unit)
        unit = frames_in(behind, frame_rate);
    else if (!behind.empty())
        return std::nullopt;
    return unit ? std::optional{*value * *unit} : std::nullopt;
}

namespace {

// What does not change is copied for each layer.
constexpr std::size_t max_layers = 500;
constexpr std::size_t max_copies = std::size_t{1} << 18;

/// Inkscape's label; for other programs, the id.
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

/// Ids are unique in a text, so a copied layer has other ids than the one it was copied from.
void forget_ids(Part& part)
{
    part.id.clear();
    for (Part& inner : part.parts)
        forget_ids(inner);
}

std::size_t count_of(const Part& part)
{
    std::size_t count = 1;
    for (const Part& inner : part.parts)
        count += count_of(inner);
    return count;
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
    if (layers.size() > max_layers)
        throw Failure("more than " + std::to_string(max_layers) +
                      " layers are named by a frame: take some of them out");
    const auto same = std::ranges::adjacent_find(layers, {}, &KeyLayer::time);
    if (same != layers.end())
        throw Failure("the layers \"" + same->name + "\" and \"" + std::next(same)->name +
                      "\" are named by the same frame: rename one of them");
    return layers;
}

std::vector<Pose> poses_of(const Part& root, const std::vector<KeyLayer>& layers, const KeyOptions& options)
{
    std::vector<const KeyLayer*> layer_of_part;
    std::size_t shared = 0;
    for (const Part& part : root.parts) {
        layer_of_part.push_back(layer_of(part, layers));
        shared += layer_of_part.back() == nullptr ? count_of(part) : 0;
    }
    if (shared * layers.size() > max_copies)
        throw Failure("there are too many shapes outside of the " + std::to_string(layers.size()) +
                      " layers that are named by frames: take some of them out");
    Part empty = root;
    empty.parts.clear();
    std::vector<Pose> poses;
    for (const KeyLayer& layer : layers) {
        Pose pose{layer.time, options.ease, empty};
        Part key;
        key.is_group = true;
        key.kind = "g";
        std::size_t place = root.parts.size();
        for (std::size_t i = 0; i < root.parts.size(); ++i) {
            const Part& part = root.parts[i];
            const KeyLayer* const of_layer = layer_of_part[i];
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

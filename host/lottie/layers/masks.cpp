#include "host/lottie/layers/layer.hpp"

#include "host/lottie/drawings/extent.hpp"
#include "host/lottie/layers/window.hpp"
#include "host/lottie/shapes/transform.hpp"

#include <utility>

namespace kfast::lottie {
namespace {

struct Mask {
    char mode = 'a'; ///< add, subtract, intersect, lighten, darken, f: difference
    bool inverted = false;
    art::Animated<art::Drawing> path;
    art::Channel opacity;
    art::Channel expansion;
};

/// The masks that have an effect.
std::vector<Mask> read_masks(const Layer& layer)
{
    std::vector<Mask> masks;
    const Reading& reading = layer.reading;
    for (const Json& json : array_at(layer.json, "masksProperties")) {
        const std::string mode = text_at(json, "mode");
        if (mode == "n")
            continue;
        masks.push_back({mode.empty() ? 'a' : mode.front(), truth_at(json, "inv", false),
                         read_path(json, "pt", reading.time, reading.budget),
                         read_channel(json, "o", 0, 1, 0.01, reading.time, reading.budget),
                         read_channel(json, "x", 0, 0, 1, reading.time, reading.budget)});
    }
    return masks;
}

Coverage coverage_by(const Mask& mask, const Box& box, double time)
{
    const double opacity = mask.opacity.at(time);
    if (opacity == 0)
        return Coverage::nothing;
    if (mask.expansion.at(time) != 0)
        return Coverage::part;
    const Coverage of_path = coverage_of(box, mask.path.at(time));
    const Coverage coverage = mask.inverted ? inverted(of_path) : of_path;
    return coverage == Coverage::all && opacity != 1 ? Coverage::part : coverage;
}

Coverage added(Coverage before, Coverage mask)
{
    if (before == Coverage::all || mask == Coverage::all)
        return Coverage::all;
    return before == mask ? before : Coverage::part;
}

Coverage intersected(Coverage before, Coverage mask)
{
    return inverted(added(inverted(before), inverted(mask)));
}

Coverage difference(Coverage before, Coverage mask)
{
    if (before == Coverage::part || mask == Coverage::part)
        return Coverage::part;
    return before == mask ? Coverage::nothing : Coverage::all;
}

Coverage joined_with(Coverage before, const Mask& mask, Coverage by_mask)
{
    switch (mask.mode) {
    case 's':
        return intersected(before, inverted(by_mask));
    case 'i':
    case 'd':
        return intersected(before, by_mask);
    case 'f':
        return difference(before, by_mask);
    default:
        return added(before, by_mask);
    }
}

/// The first mask subtracts from everything, or adds to nothing.
Coverage coverage_before(const Mask& first)
{
    return first.mode == 's' || first.mode == 'i' || first.mode == 'd' ? Coverage::all : Coverage::nothing;
}

Coverage coverage_at(const std::vector<Mask>& masks, const Box& box, double time)
{
    Coverage coverage = coverage_before(masks.front());
    for (const Mask& mask : masks)
        coverage = joined_with(coverage, mask, coverage_by(mask, box, time));
    return coverage;
}

std::size_t masks_weight(const std::vector<Mask>& masks)
{
    std::size_t total = 0;
    for (const Mask& mask : masks)
        for (const scene::Outline& outline : mask.path.keys.front().value.outlines)
            total += 16 * outline.curves.size();
    return total;
}

/// The same at all times, or part.
Coverage coverage_of(const std::vector<Mask>& masks, std::span<const art::Node> nodes, const Layer& layer)
{
    std::optional<Coverage> all_along;
    for (const double time :
         sample_times(layer.seen, weight(nodes) + masks_weight(masks), layer.reading.budget)) {
        const Box box = box_at(nodes, time);
        if (box.empty())
            continue;
        const Coverage now = coverage_at(masks, box, time);
        if (now == Coverage::part || (all_along && *all_along != now))
            return Coverage::part;
        all_along = now;
    }
    return all_along.value_or(Coverage::all);
}

bool has_outline(const art::Animated<art::Drawing>& path)
{
    return std::ranges::all_of(path.keys, [](const auto& key) { return !key.value.outlines.empty(); });
}

art::Node drawn(art::Animated<art::Drawing> drawing)
{
    art::Shape shape;
    shape.drawing = std::move(drawing);
    art::Node node;
    node.content = std::move(shape);
    return node;
}

/// Whether what the path leaves of a solid is bounded by the path alone.
bool lies_within(const Mask& mask, const art::Drawing& solid, const Layer& layer)
{
    const art::Node path = drawn(mask.path);
    const art::Node whole = drawn(solid);
    const Box bounds = box_at({&whole, 1}, layer.seen.from);
    for (const double time : sample_times(layer.seen, weight({&path, 1}), layer.reading.budget))
        if (!box_at({&path, 1}, time).lies_within(bounds))
            return false;
    return true;
}

void close(art::Animated<art::Drawing>& drawings)
{
    for (auto& key : drawings.keys)
        for (scene::Outline& outline : key.value.outlines)
            outline.closed = true;
}

bool is_added(const Mask& mask)
{
    return !mask.inverted && (mask.mode == 'a' || mask.mode == 'l' || mask.mode == 'f') &&
           has_outline(mask.path);
}

/// Whether the first mask takes away from what is there.
bool is_hole(const Mask& mask)
{
    return has_outline(mask.path) &&
           ((mask.mode == 's' && !mask.inverted) || (mask.mode == 'a' && mask.inverted));
}

art::Node shaped(const art::Node& solid, const Mask& mask)
{
    art::Node part = solid;
    auto& shape = std::get<art::Shape>(part.content);
    shape.drawing = mask.path;
    close(shape.drawing);
    shape.fill->opacity = mask.opacity;
    return part;
}

art::Node pierced(const art::Node& solid, const Mask& mask)
{
    art::Node part = shaped(solid, mask);
    auto& shape = std::get<art::Shape>(part.content);
    const scene::Outline edge = std::get<art::Shape>(solid.content).drawing.value().outlines.front();
    for (auto& key : shape.drawing.keys)
        key.value.outlines.insert(key.value.outlines.begin(), edge);
    shape.fill->rule = FillRule::even_odd;
    shape.fill->opacity = art::Channel{1};
    return part;
}

/// Whether shapes of the masks that are added show exactly what the masks do.
bool is_exact(const std::vector<Mask>& masks, const art::Node& solid, const Layer& layer)
{
    const auto& edge = std::get<art::Shape>(solid.content).drawing.value();
    const bool alone = masks.size() == 1;
    return std::ranges::all_of(masks, [&](const Mask& mask) {
        const bool joins = alone || (mask.mode != 'f' && steady_value(mask.opacity) == 1.0);
        return is_added(mask) && joins && steady_value(mask.expansion) == 0.0 &&
               lies_within(mask, edge, layer);
    });
}

bool is_exact_hole(const std::vector<Mask>& masks, const art::Node& solid, const Layer& layer)
{
    const Mask& first = masks.front();
    return masks.size() == 1 && is_hole(first) && steady_value(first.opacity) == 1.0 &&
           steady_value(first.expansion) == 0.0 &&
           lies_within(first, std::get<art::Shape>(solid.content).drawing.value(), layer);
}

std::vector<art::Node> shaped(const art::Node& solid, const std::vector<Mask>& masks)
{
    std::vector<art::Node> parts;
    for (const Mask& mask : masks)
        if (is_added(mask))
            parts.push_back(shaped(solid, mask));
    return parts;
}

/// Whether the layer is visible through the mask as through a hole.
bool is_window(const Mask& mask, bool is_first)
{
    const bool keeps_inside = mask.mode == 'i' || mask.mode == 'd' || (is_first && is_added(mask));
    return keeps_inside && !mask.inverted && has_outline(mask.path) && steady_value(mask.opacity) == 1.0 &&
           steady_value(mask.expansion) == 0.0;
}

bool are_windows(const std::vector<Mask>& masks)
{
    return std::ranges::all_of(masks,
                               [&](const Mask& mask) { return is_window(mask, &mask == &masks.front()); });
}

void cut_to(const std::vector<Mask>& masks, std::vector<art::Node>& nodes, const Layer& layer)
{
    bool is_all_cut = true;
    for (const Mask& mask : masks)
        is_all_cut = cut_to(window_of(mask.path), nodes, layer.seen, layer.reading.budget) && is_all_cut;
    if (!is_all_cut)
        layer.reading.losses.add(
            {"mask", layer.reading.layer, std::nullopt, "what reaches beyond it is seen"});
}

/// As far as that is possible; reports the rest.
void apply(const std::vector<Mask>& masks, std::vector<art::Node>& nodes, const Layer& layer)
{
    const bool is_solid = kind_of(layer.json) == LayerKind::solid;
    if (is_solid && is_exact_hole(masks, nodes.front(), layer)) {
        nodes = {pierced(nodes.front(), masks.front())};
        return;
    }
    if (is_solid && is_exact(masks, nodes.front(), layer)) {
        nodes = shaped(nodes.front(), masks);
        return;
    }
    if (are_windows(masks))
        return cut_to(masks, nodes, layer);
    if (is_solid && std::ranges::any_of(masks, is_added)) {
        nodes = shaped(nodes.front(), masks);
        layer.reading.losses.add({"masks that cut each other, or grow", layer.reading.layer, std::nullopt,
                                  "the whole shapes of those that are added"});
        return;
    }
    layer.reading.losses.add({"mask", layer.reading.layer, std::nullopt, "the layer is drawn without it"});
}

}

void apply_masks(std::vector<art::Node>& nodes, const Layer& layer)
{
    if (!find_member(layer.json, "masksProperties") || !truth_at(layer.json, "hasMask", true) ||
        nodes.empty())
        return;
    const std::vector<Mask> masks = read_masks(layer);
    if (masks.empty())
        return;
    const Coverage coverage = coverage_of(masks, nodes, layer);
    if (coverage == Coverage::nothing)
        nodes.clear();
    if (coverage == Coverage::part)
        apply(masks, nodes, layer);
}

}

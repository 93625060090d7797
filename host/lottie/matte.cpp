#include "host/lottie/matte.hpp"

#include "host/lottie/coverage.hpp"

#include <utility>

namespace kfast::lottie {
namespace {

enum class MatteMode : int { alpha = 1, inverted_alpha = 2, luminance = 3, inverted_luminance = 4 };

Coverage coverage_at(double time, std::span<const art::Node> nodes, const Layer& layer,
                     const MatteSource& source, MatteMode mode)
{
    const auto matrix = canvas_matrix(&layer.around, time);
    const auto source_matrix = canvas_matrix(&source.layer.around, time);
    if (!matrix || !source_matrix)
        return Coverage::part;
    std::vector<scene::Spot> corners = box_at(nodes, time).corners();
    for (scene::Spot& corner : corners)
        corner = matrix->of(corner);
    const bool by_luminance = mode == MatteMode::luminance || mode == MatteMode::inverted_luminance;
    const bool is_inverted = mode == MatteMode::inverted_alpha || mode == MatteMode::inverted_luminance;
    const bool is_shown = source.shown.from <= time && time < source.shown.to;
    const Coverage coverage =
        is_shown ? coverage_of(corners, source.nodes, *source_matrix, time, by_luminance) : Coverage::nothing;
    return is_inverted ? inverted(coverage) : coverage;
}

/// The opacity of the layer counts as well.
art::Node as_node(const MatteSource& source)
{
    art::Node node;
    node.opacity = read_channel(source.layer.json["ks"], "o", 0, 1, 0.01, source.layer.reading.time,
                                source.layer.reading.budget);
    node.content = art::Group{source.nodes};
    return node;
}

}

void apply_matte(std::vector<art::Node>& nodes, const Layer& layer, MatteSource source)
{
    const int mode = whole_at(layer.json, "tt", 0);
    if (find_member(source.layer.json, "ks"))
        source.nodes = {as_node(source)};
    const std::size_t effort =
        weight(nodes) + 16 * weight(source.nodes) + weight(&layer.around) + weight(&source.layer.around);
    std::optional<Coverage> all_along;
    for (const double time : sample_times(layer.seen, effort, layer.reading.budget)) {
        if (box_at(nodes, time).empty())
            continue;
        const bool known = mode >= 1 && mode <= 4;
        const Coverage now =
            known ? coverage_at(time, nodes, layer, source, MatteMode{mode}) : Coverage::part;
        const bool same = !all_along || *all_along == now;
        all_along = same ? now : Coverage::part;
        if (*all_along == Coverage::part)
            break;
    }
    if (all_along == Coverage::nothing)
        nodes.clear();
    if (all_along == Coverage::part)
        report_matte(layer);
}

void report_matte(const Layer& layer)
{
    layer.reading.losses.add({"matte", layer.reading.layer, std::nullopt, "the layer is drawn without it"});
}

}

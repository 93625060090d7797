#include "host/lottie/layers/layer.hpp"

#include "host/art/document/document.hpp"
#include "host/lottie/drawings/carried.hpp"
#include "host/lottie/drawings/extent.hpp"
#include "host/lottie/layers/window.hpp"
#include "host/lottie/shapes/transform.hpp"

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
    std::vector<scene::Vec2> corners = box_at(nodes, time).corners();
    for (scene::Vec2& corner : corners)
        corner = matrix->of(corner);
    const bool by_luminance = mode == MatteMode::luminance || mode == MatteMode::inverted_luminance;
    const bool is_inverted = mode == MatteMode::inverted_alpha || mode == MatteMode::inverted_luminance;
    const bool is_shown = source.shown.from <= time && time < source.shown.to;
    const Coverage coverage =
        is_shown ? coverage_of(corners, source.nodes, *source_matrix, time, by_luminance) : Coverage::nothing;
    return is_inverted ? inverted(coverage) : coverage;
}

using TransformPath = std::vector<const art::Transform*>;

/// A filled shape of which only the form matters.
struct LoneShape {
    const art::Shape* content;
    TransformPath way; ///< the outermost first
};

/// Nothing if there is more than one shape, or one that is transparent or not always there.
std::optional<LoneShape> lone_shape(const std::vector<art::Node>& nodes)
{
    LoneShape shape{};
    const std::vector<art::Node>* inside = &nodes;
    while (!shape.content) {
        if (inside->size() != 1)
            return std::nullopt;
        const art::Node& node = inside->front();
        if (steady_value(node.opacity) != 1.0 || node.shown != std::vector<art::Span>{{}})
            return std::nullopt;
        shape.way.push_back(&node.transform);
        if (const auto* group = std::get_if<art::Group>(&node.content))
            inside = &group->nodes;
        else
            shape.content = &std::get<art::Shape>(node.content);
    }
    const bool is_filled = shape.content->fill && steady_value(shape.content->fill->opacity) == 1.0;
    return is_filled && !shape.content->stroke ? std::optional{std::move(shape)} : std::nullopt;
}

/// The transforms around the first that are not around the other one as well, the innermost first.
TransformPath own_way(const Around* around, const Around* other)
{
    TransformPath way;
    const auto is_around_other = [&](const Around* one) {
        const Around* outer = other;
        while (outer && outer != one)
            outer = outer->outer;
        return outer == one;
    };
    for (; around && !is_around_other(around); around = around->outer)
        way.push_back(around->transform);
    return way;
}

art::Affine matrix_from(const TransformPath& innermost_first, double time)
{
    art::Affine matrix;
    for (const art::Transform* transform : innermost_first)
        matrix = art::matrix_at(*transform, time) * matrix;
    return matrix;
}

/// In the coordinates of the matted layer; the layers must outlive it. Nothing if no window is equivalent.
std::optional<Window> window_through(const Layer& layer, const MatteSource& source)
{
    const auto shape = lone_shape(source.nodes);
    if (!shape || source.shown.from > layer.seen.from || source.shown.to < layer.seen.to)
        return std::nullopt;
    TransformPath inner{shape->way.rbegin(), shape->way.rend()};
    const TransformPath to_layers = own_way(&source.layer.around, &layer.around);
    inner.insert(inner.end(), to_layers.begin(), to_layers.end());
    const TransformPath outer = own_way(&layer.around, &source.layer.around);
    Window window = window_of(shape->content->drawing);
    window.rule = shape->content->fill->rule;
    for (const TransformPath* way : std::initializer_list<const TransformPath*>{&inner, &outer})
        for (const art::Transform* transform : *way) {
            if (!transform || !is_flat(*transform))
                return std::nullopt;
            window.drawing.moments.add(moments_of(*transform));
        }
    window.drawing.cost += static_cast<double>(inner.size() + outer.size());
    window.drawing.at = [inner, outer, at = std::move(window.drawing.at)](double time) {
        art::Drawing drawing = at(time);
        const auto back = matrix_from(outer, time).inverse();
        const art::Affine matrix = back.value_or(art::Affine{}) * matrix_from(inner, time);
        for (scene::Outline& outline : drawing.outlines)
            outline = matrix.of(outline);
        return drawing;
    };
    return window;
}

/// Applies a matte that is one shape.
bool cut_by_shape(std::vector<art::Node>& nodes, const Layer& layer, const MatteSource& source, int mode)
{
    const auto window = MatteMode{mode} == MatteMode::alpha ? window_through(layer, source) : std::nullopt;
    if (!window)
        return false;
    if (!cut_to(*window, nodes, layer.seen, layer.reading.budget))
        layer.reading.losses.add(
            {"matte", layer.reading.layer, std::nullopt, "what reaches beyond it is seen"});
    return true;
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
    if (all_along == Coverage::part && !cut_by_shape(nodes, layer, source, mode))
        report_matte(layer);
}

void report_matte(const Layer& layer)
{
    layer.reading.losses.add({"matte", layer.reading.layer, std::nullopt, "the layer is drawn without it"});
}

}

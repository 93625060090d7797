#include "host/synfig/layers/cover_layers.hpp"

#include "host/geometry/shape.hpp"
#include "host/synfig/layers/blending.hpp"
#include "host/synfig/layers/group_layers.hpp"
#include "host/synfig/layers/shape_layers.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <string_view>

namespace kfast::synfig {
namespace {

bool is_solid(const Layer& layer) { return layer.type() == "SolidColor" || layer.type() == "solid_color"; }

bool is_gradient(const Layer& layer)
{
    return layer.type().ends_with("_gradient") || layer.type() == "noise";
}

/// The visible part of a radial gradient whose rim is transparent.
struct Glow {
    double share = 1; ///< fraction of the radius at half of the opacity
    Colour colour;
};

std::optional<Glow> glow_of(const Gradient& gradient)
{
    constexpr double nothing = 0.02;
    constexpr int rings = 64;
    if (gradient.at(1).alpha > nothing)
        return {};
    double max = 0;
    for (int ring = 0; ring < rings; ++ring)
        max = std::max(max, gradient.at(static_cast<double>(ring) / rings).alpha);
    if (max <= nothing)
        return {};
    int outermost = rings;
    while (outermost > 1 && gradient.at(static_cast<double>(outermost) / rings).alpha < max / 2)
        --outermost;
    Colour total{0, 0, 0, 0};
    double area = 0;
    for (int ring = 0; ring < outermost; ++ring) {
        const double radius = ring + 0.5;
        area += radius;
        total = mixed(total, weighted(gradient.at(radius / rings)), radius / area);
    }
    return Glow{static_cast<double>(outermost) / rings, unweighted(total)};
}

std::optional<Glow> glow_at(const Layer& layer, double frame)
{
    if (layer.type() != "radial_gradient" || layer.truth("loop", frame, false))
        return {};
    return glow_of(layer.at("gradient", frame).as<Gradient>());
}

art::Shape circle(const Layer& layer, double share)
{
    const std::function<art::Drawing(double)> drawing = [&](double frame) {
        const double radius = share * std::abs(layer.number("radius", frame, 0.5));
        const scene::Outline outline = scene::ellipse(layer.spot("center", frame), radius, radius);
        return art::Drawing{{layer.reading().to_canvas.of(outline)}};
    };
    art::Shape shape;
    shape.drawing = traced(drawing, layer.tracing({"center", "radius"}, place_tolerance));
    return shape;
}

art::Node gradient_node(const Layer& layer)
{
    art::Node node = node_of(layer);
    art::Shape shape;
    if (const auto glow = glow_at(layer, 0); glow && layer.bends({"gradient"}).empty()) {
        layer.lose("gradient", "a circle in its mean colour");
        shape = circle(layer, glow->share);
        shape.fill = art::Fill{layer.rgb(glow->colour), glow->colour.alpha, FillRule::nonzero};
    } else {
        layer.lose(layer.type() == "noise" ? "noise" : "gradient", "its mean colour all over");
        shape.drawing = art::Drawing{{everywhere(layer.reading())}};
        shape.fill = fill_of(layer);
    }
    node.content = std::move(shape);
    return node;
}

/// Whether a layer draws nothing by itself but changes what is below it.
bool is_change(const Layer& layer)
{
    static constexpr std::string_view types[] = {
        "translate",  "rotate",       "zoom",  "stretch",  "timeloop", "freetime", "skeleton_deformation",
        "warp",       "blur",         "twirl", "spherize", "clamp",    "skeleton", "colorcorrect",
        "MotionBlur", "noise_distort"};
    return std::ranges::find(types, layer.type()) != std::end(types);
}

}

bool is_cover(const Layer& layer) { return is_solid(layer) || is_gradient(layer); }

std::optional<art::Node> read_cover_layer(const Layer& layer)
{
    if (is_gradient(layer))
        return gradient_node(layer);
    if (!is_solid(layer))
        return {};
    layer.lose_others({"color"});
    art::Node node = node_of(layer);
    art::Shape shape;
    shape.drawing = art::Drawing{{everywhere(layer.reading())}};
    shape.fill = fill_of(layer);
    node.content = std::move(shape);
    return node;
}

const char* colour_name(const Layer& layer) { return is_gradient(layer) ? "gradient" : "color"; }

Colour colour_at(const Layer& layer, double frame)
{
    const Value value = layer.at(colour_name(layer), frame);
    return is_gradient(layer) ? value.as<Gradient>().mean() : value.as<Colour>();
}

scene::Outline everywhere(const Reading& reading)
{
    const double x = std::min(reading.width, 600.0);
    const double y = std::min(reading.height, 600.0);
    return scene::rectangle({-x, -y}, reading.width + 2 * x, reading.height + 2 * y, 0);
}

std::optional<CoverGroup> covers_in(const Layer& group)
{
    if (!is_group(group) || group.type() == "switch")
        return {};
    std::optional<CoverGroup> found;
    const Scope inner = inside_of(group);
    art::Budget::check_depth(inner.depth);
    for (const pugi::xml_node child : group.canvas().children("layer")) {
        const Layer layer{child, group.reading(), inner};
        if (!layer.is_drawn() || is_change(layer))
            continue;
        const auto inside = is_cover(layer) ? std::optional{CoverGroup{layer}} : covers_in(layer);
        if (inside && !found)
            found = inside;
        else if (inside || (found && takes_away(layer)))
            found->is_alone = false;
        else
            return {};
    }
    return found;
}

}

#include "host/svg/style/paint.hpp"

#include "host/svg/markup/length.hpp"
#include "host/svg/markup/svg_text.hpp"

#include <algorithm>
#include <vector>

namespace kfast::svg {
namespace {

struct Stop {
    double offset;
    Ink ink;
};

struct Painter {
    const Style& style;
    const ElementIndex& index;
    StyleSheet& sheet;
    const std::string& layer;
    art::Losses& losses;
};

std::optional<Ink> plain(std::string_view value, const Style& style)
{
    if (value == "currentColor" || value == "currentcolor")
        return colour(style.get("color", "black"));
    return colour(value);
}

std::vector<Stop> own_stops(pugi::xml_node gradient, const Painter& painter)
{
    std::vector<Stop> stops;
    for (const pugi::xml_node child : gradient.children()) {
        if (element_name(child) != "stop")
            continue;
        const Style style{painter.style, child, painter.sheet};
        Ink ink = plain(style.get("stop-color", "black"), style).value_or(Ink{});
        ink.opacity *= std::clamp(share(style["stop-opacity"]).value_or(1), 0.0, 1.0);
        const double offset = std::clamp(share(child.attribute("offset").value()).value_or(0), 0.0, 1.0);
        stops.push_back({stops.empty() ? offset : std::max(offset, stops.back().offset), ink});
    }
    return stops;
}

/// The stops of the first gradient in the chain of references that has any.
std::vector<Stop> stops_of(pugi::xml_node gradient, const Painter& painter)
{
    constexpr int longest_chain = 32;
    for (int link = 0; gradient && link < longest_chain; ++link) {
        auto stops = own_stops(gradient, painter);
        if (!stops.empty())
            return stops;
        gradient = painter.index.find(referred_id(gradient));
    }
    return {};
}

/// The mean over all offsets, weighted by opacity.
Ink mean_of(const std::vector<Stop>& stops)
{
    double opacity = 0;
    art::Rgb sum;
    const auto add = [&](const Ink& ink, double weight) {
        const double seen = ink.opacity * weight;
        opacity += seen;
        sum = {sum.red + seen * ink.colour.red, sum.green + seen * ink.colour.green,
               sum.blue + seen * ink.colour.blue};
    };
    add(stops.front().ink, stops.front().offset);
    for (std::size_t i = 1; i < stops.size(); ++i) {
        const double half = (stops[i].offset - stops[i - 1].offset) / 2;
        add(stops[i - 1].ink, half);
        add(stops[i].ink, half);
    }
    add(stops.back().ink, 1 - stops.back().offset);
    if (opacity <= 0)
        return {{}, 0};
    return {{std::min(sum.red / opacity, 1.0), std::min(sum.green / opacity, 1.0),
             std::min(sum.blue / opacity, 1.0)},
            std::min(opacity, 1.0)};
}

std::optional<Ink> of_gradient(pugi::xml_node gradient, const Painter& painter)
{
    const auto stops = stops_of(gradient, painter);
    if (stops.empty())
        return std::nullopt;
    const bool is_even =
        std::ranges::all_of(stops, [&](const Stop& stop) { return stop.ink == stops.front().ink; });
    if (!is_even)
        painter.losses.add({"gradient", painter.layer, {}, "its mean colour"});
    return mean_of(stops);
}

/// "url(#id) red": what is painted without the element of that id.
std::optional<Ink> fallback(std::string_view value, const Style& style)
{
    const std::size_t end = value.find(')');
    return end == value.npos ? std::nullopt : plain(trimmed(value.substr(end + 1)), style);
}

std::optional<Ink> of_reference(std::string_view value, const Painter& painter)
{
    const pugi::xml_node server = painter.index.find(url_id(value));
    const std::string_view kind = element_name(server);
    if (kind == "linearGradient" || kind == "radialGradient")
        return of_gradient(server, painter);
    const auto instead = fallback(value, painter.style);
    if (kind == "pattern" || kind == "hatch" || kind == "meshgradient" || kind == "mesh")
        painter.losses.add({std::string{kind}, painter.layer, {}, instead ? "its other colour" : "nothing"});
    return instead;
}

}

std::optional<Ink> paint(std::string_view property, const Style& style, const ElementIndex& index,
                         StyleSheet& sheet, const std::string& layer, art::Losses& losses)
{
    const std::string_view value = style.get(property, property == "fill" ? "black" : "none");
    if (value == "none")
        return std::nullopt;
    auto ink = value.starts_with("url(") ? of_reference(value, {style, index, sheet, layer, losses})
                                         : plain(value, style);
    if (!ink && !value.starts_with("url("))
        losses.add({std::string{property} + " \"" + shortened(value) + '"', layer, {}, "nothing is painted"});
    if (ink)
        ink->opacity *= std::clamp(share(style[std::string{property} + "-opacity"]).value_or(1), 0.0, 1.0);
    if (ink && ink->opacity <= 0)
        return std::nullopt;
    return ink;
}

}

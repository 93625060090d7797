#include "host/svg/elements/element_outlines.hpp"

#include "host/geometry/arc.hpp"
#include "host/geometry/shape.hpp"
#include "host/geometry/svg_path.hpp"
#include "host/scene/context/limits.hpp"
#include "host/svg/markup/length.hpp"
#include "host/svg/markup/svg_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace kfast::svg {
namespace {

using scene::Outline;
using scene::Vec2;
using Outlines = std::vector<Outline>;

struct Shape {
    pugi::xml_node node;
    const Style& style;
    const Measure& measure;
    const std::string& layer;
    art::Losses& losses;

    /// Nothing where it is "auto" or not set.
    std::optional<double> given(const char* name, Axis axis) const
    {
        return reported_length(name, style[name], axis, measure, layer, losses);
    }
    double get(const char* name, Axis axis) const { return given(name, axis).value_or(0); }
    /// A value below 0 is an error, which leaves it "auto".
    std::optional<double> radius(const char* name, Axis axis) const
    {
        const auto value = given(name, axis);
        return value && *value >= 0 ? value : std::nullopt;
    }
    /// For the attributes of lines, which are no properties.
    double coordinate(const char* name, Axis axis) const
    {
        return reported_length(name, node.attribute(name).value(), axis, measure, layer, losses).value_or(0);
    }
};

/// Clockwise from the end of its upper left corner, as in SVG; corners are elliptic arcs.
Outline rounded(double x, double y, double width, double height, double rx, double ry)
{
    const double right = x + width;
    const double bottom = y + height;
    Outline outline{{x + rx, y}, {}, true};
    const auto side = [&](Vec2 to) {
        const Vec2 last = outline.curves.empty() ? outline.from : outline.curves.back().to;
        if (scene::distance(last, to) > 0)
            outline.curves.push_back(scene::line_to(to));
    };
    const auto corner = [&](Vec2 to) {
        const scene::Arc arc{
            outline.curves.empty() ? outline.from : outline.curves.back().to, to, rx, ry, 0, false, true};
        for (const scene::Curve& curve : scene::curves_of(arc))
            outline.curves.push_back(curve);
    };
    side({right - rx, y});
    corner({right, y + ry});
    side({right, bottom - ry});
    corner({right - rx, bottom});
    side({x + rx, bottom});
    corner({x, bottom - ry});
    side({x, y + ry});
    corner({x + rx, y});
    return outline;
}

Outlines rect(const Shape& shape)
{
    const double x = shape.get("x", Axis::x);
    const double y = shape.get("y", Axis::y);
    const double width = shape.get("width", Axis::x);
    const double height = shape.get("height", Axis::y);
    if (width <= 0 || height <= 0)
        return {};
    const auto rx = shape.radius("rx", Axis::x);
    const auto ry = shape.radius("ry", Axis::y);
    const double corner_x = std::clamp(rx.value_or(ry.value_or(0)), 0.0, width / 2);
    const double corner_y = std::clamp(ry.value_or(rx.value_or(0)), 0.0, height / 2);
    if (corner_x == 0 || corner_y == 0)
        return {scene::rectangle({x, y}, width, height, 0)};
    if (corner_x == corner_y)
        return {scene::rectangle({x, y}, width, height, corner_x)};
    return {rounded(x, y, width, height, corner_x, corner_y)};
}

Outlines round(const Shape& shape, double radius_x, double radius_y)
{
    if (radius_x <= 0 || radius_y <= 0)
        return {};
    return {scene::ellipse({shape.get("cx", Axis::x), shape.get("cy", Axis::y)}, radius_x, radius_y)};
}

Outlines circle(const Shape& shape)
{
    const double radius = shape.get("r", Axis::diagonal);
    return round(shape, radius, radius);
}

Outlines ellipse(const Shape& shape)
{
    const auto rx = shape.radius("rx", Axis::x);
    const auto ry = shape.radius("ry", Axis::y);
    return round(shape, rx.value_or(ry.value_or(0)), ry.value_or(rx.value_or(0)));
}

Outlines line(const Shape& shape)
{
    const std::array spots{Vec2{shape.coordinate("x1", Axis::x), shape.coordinate("y1", Axis::y)},
                           Vec2{shape.coordinate("x2", Axis::x), shape.coordinate("y2", Axis::y)}};
    return {scene::polyline(spots, false)};
}

Outlines through_points(const Shape& shape, bool closed)
{
    const std::string_view text = shape.node.attribute("points").value();
    std::string_view rest;
    const auto values = numbers(text, rest);
    if (!rest.empty() || values.size() % 2 != 0)
        shape.losses.add({"points: " + shortened(text), shape.layer, {}, "those up to the mistake"});
    std::vector<Vec2> spots;
    for (std::size_t i = 0; i + 1 < values.size(); i += 2)
        spots.push_back(
            {std::clamp(values[i], -farthest, farthest), std::clamp(values[i + 1], -farthest, farthest)});
    if (spots.size() < 2)
        return {};
    return {scene::polyline(spots, closed)};
}

Outlines polyline(const Shape& shape) { return through_points(shape, false); }
Outlines polygon(const Shape& shape) { return through_points(shape, true); }

Outlines path(const Shape& shape)
{
    std::string_view data = trimmed(shape.style["d"]);
    if (data == "none")
        return {};
    if (data.starts_with("path(") && data.size() > 8) // as CSS writes it, in quotes
        data = data.substr(6, data.size() - 8);
    Diagnostics findings;
    Outlines outlines = scene::read_svg_path(data, scene::max_points, findings, farthest);
    for (const Diagnostic& finding : findings.sorted())
        if (finding.severity == Severity::error)
            shape.losses.add({"path data: " + finding.message + ", at character " +
                                  std::to_string(finding.place.offset + 1),
                              shape.layer,
                              {},
                              "the path ends there"});
    return outlines;
}

struct Kind {
    std::string_view name;
    Outlines (*outlines)(const Shape&);
};
constexpr std::array<Kind, 7> kinds{{{"rect", rect},
                                     {"circle", circle},
                                     {"ellipse", ellipse},
                                     {"line", line},
                                     {"polyline", polyline},
                                     {"polygon", polygon},
                                     {"path", path}}};

}

bool is_shape(std::string_view name) { return std::ranges::find(kinds, name, &Kind::name) != kinds.end(); }

art::Drawing outlines_of(pugi::xml_node shape, const Style& style, const Measure& measure,
                         const std::string& layer, art::Budget& budget, art::Losses& losses)
{
    const auto kind = std::ranges::find(kinds, element_name(shape), &Kind::name);
    art::Drawing drawing{kind->outlines({shape, style, measure, layer, losses})};
    for (const Outline& outline : drawing.outlines)
        budget.take_points(1 + outline.curves.size());
    return drawing;
}

}

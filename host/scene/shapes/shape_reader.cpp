#include "host/scene/shapes/shape_reader.hpp"

#include "host/geometry/outline.hpp"
#include "host/geometry/shape.hpp"
#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/shapes/label_reader.hpp"
#include "host/scene/shapes/text_reader.hpp"
#include "host/scene/values/geometry_reader.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <vector>

namespace kfast::scene {

namespace {

/// As read_shape(), for the nodes polygon, line and curve, whose form has been checked.
std::vector<Outline> read_polygon(const kdl::Node& node, std::size_t points_left, SceneContext& context);
std::vector<Outline> read_line(const kdl::Node& node, std::size_t points_left, SceneContext& context);
std::vector<Outline> read_curve(const kdl::Node& node, std::size_t points_left, SceneContext& context);

std::vector<Outline> read_polyline(const kdl::Node& node, bool closed, SceneContext& context)
{
    const bool good = refuse_properties(node, context.report);
    const auto spots = read_spots(node, context);
    if (!good || !spots)
        return {};
    return {polyline(*spots, closed)};
}

bool read_closed(const kdl::Value& value, bool& closed, SceneContext& context)
{
    return assign(read_flag(value, context.report), closed);
}

constexpr std::array curve_rules{PropertyRule<bool>{"closed", read_closed, truth}};

std::vector<Outline> read_polygon(const kdl::Node& node, std::size_t, SceneContext& context)
{
    return read_polyline(node, true, context);
}

std::vector<Outline> read_line(const kdl::Node& node, std::size_t, SceneContext& context)
{
    return read_polyline(node, false, context);
}

std::vector<Outline> read_curve(const kdl::Node& node, std::size_t, SceneContext& context)
{
    bool closed = false;
    const bool good = read_properties(node, curve_rules, closed, context);
    const auto spots = read_spots(node, context);
    if (!good || !spots)
        return {};
    return {spline(*spots, closed)};
}

std::vector<PropertySchema> curve_schema() { return schema_of(curve_rules); }

/// The values of the properties of circle, ellipse and rect.
struct Radii {
    double x = 0;
    double y = 0;
};

bool read_radius_x(const kdl::Value& value, Radii& radii, SceneContext& context)
{
    return assign(read_number(value, extents, context.report), radii.x);
}

bool read_radius_y(const kdl::Value& value, Radii& radii, SceneContext& context)
{
    return assign(read_number(value, extents, context.report), radii.y);
}

constexpr std::array circle_rules{PropertyRule<Radii>{"r", read_radius_x, ValueKind::pixels(extents), true}};
constexpr std::array ellipse_rules{
    PropertyRule<Radii>{"rx", read_radius_x, ValueKind::pixels(extents), true},
    PropertyRule<Radii>{"ry", read_radius_y, ValueKind::pixels(extents), true}};
constexpr std::array rect_rules{PropertyRule<Radii>{"corner", read_radius_x, ValueKind::pixels(extents)}};

std::vector<Outline> read_circle(const kdl::Node& node, std::size_t, SceneContext& context)
{
    Radii radii;
    const bool good = read_properties(node, circle_rules, radii, context);
    const auto centre = read_spot(node, context);
    if (!good || !centre)
        return {};
    return {ellipse(*centre, radii.x, radii.x)};
}

std::vector<Outline> read_ellipse(const kdl::Node& node, std::size_t, SceneContext& context)
{
    Radii radii;
    const bool good = read_properties(node, ellipse_rules, radii, context);
    const auto centre = read_spot(node, context);
    if (!good || !centre)
        return {};
    return {ellipse(*centre, radii.x, radii.y)};
}

std::vector<Outline> read_rectangle(const kdl::Node& node, std::size_t, SceneContext& context)
{
    Radii corner;
    const bool good = read_properties(node, rect_rules, corner, context);
    const auto box =
        read_numbers(node.arguments, std::array{coordinates, coordinates, extents}, context.report);
    if (!good || !box)
        return {};
    return {rectangle({box->at(0), box->at(1)}, box->at(2), box->at(3), corner.x)};
}

using Words = std::vector<std::vector<PropertySchema>>;

struct Shape {
    NodeForm form;
    std::vector<Outline> (*read)(const kdl::Node&, std::size_t points_left, SceneContext&);
    std::span<const ValueKind> values;
    Words (*properties)(); ///< one list for each form of it
};

constexpr ValueKind coordinate = ValueKind::pixels(coordinates);
constexpr ValueKind extent = ValueKind::pixels(extents);
constexpr std::array path_values{any_path};
constexpr std::array spot_values{coordinate};
constexpr std::array box_values{coordinate, coordinate, extent};

template <const auto& rules>
Words words_of_rules()
{
    return {schema_of(rules)};
}

Words no_properties() { return {{}}; }

/// Texts list their own.
Words no_words() { return {}; }

constexpr std::array shapes{
    Shape{{"path", "path \"M … L …\"", 1, 1}, read_path, path_values, no_properties},
    Shape{{"circle", "circle CX CY r=RADIUS", 2, 2}, read_circle, spot_values, words_of_rules<circle_rules>},
    Shape{{"ellipse", "ellipse CX CY rx=RADIUS ry=RADIUS", 2, 2},
          read_ellipse,
          spot_values,
          words_of_rules<ellipse_rules>},
    Shape{{"rect", "rect X Y WIDTH HEIGHT corner=RADIUS", 4, 4},
          read_rectangle,
          box_values,
          words_of_rules<rect_rules>},
    Shape{{"arc", "arc CX CY r=RADIUS from=DEGREES to=DEGREES", 2, 2}, read_arc, spot_values, arc_schema},
    Shape{{"pie", "pie CX CY r=RADIUS from=DEGREES to=DEGREES inner=RADIUS", 2, 2},
          read_pie,
          spot_values,
          [] { return Words{pie_schema()}; }},
    Shape{{"polygon", "polygon X Y X Y X Y …", 6, NodeForm::any_number},
          read_polygon,
          spot_values,
          no_properties},
    Shape{{"regular", "regular CX CY sides=NUMBER r=RADIUS turn=DEGREES", 2, 2},
          read_regular,
          spot_values,
          [] { return Words{regular_schema()}; }},
    Shape{{"star", "star CX CY points=NUMBER r=RADIUS inner=RADIUS turn=DEGREES", 2, 2},
          read_star,
          spot_values,
          [] { return Words{star_schema()}; }},
    Shape{{"line", "line X Y X Y …", 4, NodeForm::any_number}, read_line, spot_values, no_properties},
    Shape{{"curve", "curve X Y X Y … closed=#true", 4, NodeForm::any_number},
          read_curve,
          spot_values,
          [] { return Words{curve_schema()}; }},
    Shape{{"text", "text \"WORDS\" at=\"X,Y\" size=PIXELS font=FONT", 0, 1}, read_text_shape, {}, no_words},
};

constexpr auto names = [] {
    std::array<std::string_view, shapes.size()> list;
    std::ranges::transform(shapes, list.begin(), [](const Shape& shape) { return shape.form.name; });
    return list;
}();

}

std::span<const std::string_view> shape_names() { return names; }

bool is_shape(std::string_view name) { return std::ranges::find(names, name) != names.end(); }

std::vector<Outline> read_shape(const kdl::Node& node, std::size_t points_left, SceneContext& context)
{
    const auto index = std::ranges::find(names, node.name) - names.begin();
    const Shape& shape = shapes[static_cast<std::size_t>(index)];
    if (!fits(node, shape.form, context.report))
        return {};
    return shape.read(node, points_left, context);
}

std::vector<NodeSchema> shape_schema()
{
    std::vector<NodeSchema> words{text_schema(), path_text_schema(), label_schema()};
    for (const Shape& shape : shapes)
        for (auto& properties : shape.properties())
            words.push_back({shape.form.name,
                             shape.form,
                             {shape.values.begin(), shape.values.end()},
                             std::move(properties)});
    return words;
}

}

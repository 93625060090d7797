#include "host/scene/shape_reader.hpp"

#include "host/scene/node_form.hpp"
#include "host/scene/path_reader.hpp"
#include "host/scene/polyline_reader.hpp"
#include "host/scene/property_rule.hpp"
#include "host/scene/sector_reader.hpp"
#include "host/scene/shape.hpp"
#include "host/scene/spot_reader.hpp"
#include "host/scene/star_reader.hpp"
#include "host/scene/text_reader.hpp"
#include "host/scene/value_reader.hpp"

#include <algorithm>
#include <array>
#include <iterator>

namespace kfast::scene {
namespace {

/// What the properties of circle, ellipse and rect give.
struct Radii {
    double x = 0;
    double y = 0;
};

bool read_radius_x(const kdl::Value& value, Radii& radii, Reading& reading)
{
    return assign(read_number(value, extents, reading), radii.x);
}

bool read_radius_y(const kdl::Value& value, Radii& radii, Reading& reading)
{
    return assign(read_number(value, extents, reading), radii.y);
}

constexpr std::array circle_rules{PropertyRule<Radii>{"r", read_radius_x, true}};
constexpr std::array ellipse_rules{PropertyRule<Radii>{"rx", read_radius_x, true},
                                   PropertyRule<Radii>{"ry", read_radius_y, true}};
constexpr std::array rect_rules{PropertyRule<Radii>{"corner", read_radius_x}};

std::vector<Outline> read_circle(const kdl::Node& node, std::size_t, Reading& reading)
{
    Radii radii;
    const bool good = read_properties(node, circle_rules, radii, reading);
    const auto centre = read_spot(node, reading);
    if (!good || !centre)
        return {};
    return {ellipse(*centre, radii.x, radii.x)};
}

std::vector<Outline> read_ellipse(const kdl::Node& node, std::size_t, Reading& reading)
{
    Radii radii;
    const bool good = read_properties(node, ellipse_rules, radii, reading);
    const auto centre = read_spot(node, reading);
    if (!good || !centre)
        return {};
    return {ellipse(*centre, radii.x, radii.y)};
}

std::vector<Outline> read_rectangle(const kdl::Node& node, std::size_t, Reading& reading)
{
    Radii corner;
    const bool good = read_properties(node, rect_rules, corner, reading);
    const auto box = read_numbers(node.arguments, std::array{coordinates, coordinates, extents}, reading);
    if (!good || !box)
        return {};
    return {rectangle({box->at(0), box->at(1)}, box->at(2), box->at(3), corner.x)};
}

struct Shape {
    NodeForm form;
    std::vector<Outline> (*read)(const kdl::Node&, std::size_t points_left, Reading&);
};

constexpr std::array shapes{
    Shape{{"path", "path \"M … L …\"", 1, 1}, read_path},
    Shape{{"circle", "circle CX CY r=RADIUS", 2, 2}, read_circle},
    Shape{{"ellipse", "ellipse CX CY rx=RADIUS ry=RADIUS", 2, 2}, read_ellipse},
    Shape{{"rect", "rect X Y WIDTH HEIGHT corner=RADIUS", 4, 4}, read_rectangle},
    Shape{{"arc", "arc CX CY r=RADIUS from=DEGREES to=DEGREES", 2, 2}, read_arc},
    Shape{{"pie", "pie CX CY r=RADIUS from=DEGREES to=DEGREES inner=RADIUS", 2, 2}, read_pie},
    Shape{{"polygon", "polygon X Y X Y X Y …", 6, NodeForm::any_number}, read_polygon},
    Shape{{"regular", "regular CX CY sides=NUMBER r=RADIUS turn=DEGREES", 2, 2}, read_regular},
    Shape{{"star", "star CX CY points=NUMBER r=RADIUS inner=RADIUS turn=DEGREES", 2, 2}, read_star},
    Shape{{"line", "line X Y X Y …", 4, NodeForm::any_number}, read_line},
    Shape{{"curve", "curve X Y X Y … closed=#true", 4, NodeForm::any_number}, read_curve},
    Shape{{"text", "text \"WORDS\" at=\"X,Y\" size=PIXELS font=FONT", 0, 1}, read_text_shape},
};

constexpr auto names = [] {
    std::array<std::string_view, shapes.size()> list;
    std::ranges::transform(shapes, list.begin(), [](const Shape& shape) { return shape.form.name; });
    return list;
}();

}

std::span<const std::string_view> shape_names() { return names; }

bool is_shape(std::string_view name) { return std::ranges::find(names, name) != names.end(); }

std::vector<Outline> read_shape(const kdl::Node& node, std::size_t points_left, Reading& reading)
{
    const auto index = std::ranges::find(names, node.name) - names.begin();
    const Shape& shape = shapes[static_cast<std::size_t>(index)];
    if (!fits(node, shape.form, reading))
        return {};
    return shape.read(node, points_left, reading);
}

}

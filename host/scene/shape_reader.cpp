#include "host/scene/shape_reader.hpp"

#include "host/scene/node_form.hpp"
#include "host/scene/property_rule.hpp"
#include "host/scene/shape.hpp"
#include "host/scene/svg_path.hpp"
#include "host/scene/value_reader.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string>

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

/// All values of `node`; the last of `ranges` holds for all that follow.
std::optional<std::vector<double>> read_numbers(const kdl::Node& node, std::span<const Range> ranges,
                                                Reading& reading)
{
    std::vector<double> numbers;
    for (const kdl::Value& value : node.arguments) {
        const std::size_t place = std::min(numbers.size(), ranges.size() - 1);
        const auto number = read_number(value, ranges[place], reading);
        if (!number)
            return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

std::vector<Outline> read_circle(const kdl::Node& node, std::size_t, Reading& reading)
{
    Radii radii;
    const bool good = read_properties(node, circle_rules, radii, reading);
    const auto centre = read_numbers(node, std::array{coordinates}, reading);
    if (!good || !centre)
        return {};
    return {ellipse({centre->at(0), centre->at(1)}, radii.x, radii.x)};
}

std::vector<Outline> read_ellipse(const kdl::Node& node, std::size_t, Reading& reading)
{
    Radii radii;
    const bool good = read_properties(node, ellipse_rules, radii, reading);
    const auto centre = read_numbers(node, std::array{coordinates}, reading);
    if (!good || !centre)
        return {};
    return {ellipse({centre->at(0), centre->at(1)}, radii.x, radii.y)};
}

std::vector<Outline> read_rectangle(const kdl::Node& node, std::size_t, Reading& reading)
{
    Radii corner;
    const bool good = read_properties(node, rect_rules, corner, reading);
    const auto box = read_numbers(node, std::array{coordinates, coordinates, extents}, reading);
    if (!good || !box)
        return {};
    return {rectangle({box->at(0), box->at(1)}, box->at(2), box->at(3), corner.x)};
}

std::vector<Outline> read_polyline(const kdl::Node& node, bool closed, Reading& reading)
{
    const bool good = refuse_properties(node, reading);
    const auto numbers = read_numbers(node, std::array{coordinates}, reading);
    if (!good || !numbers)
        return {};
    if (numbers->size() % 2 != 0) {
        reading.report.error(node.arguments.back().place, "this x has no y");
        return {};
    }
    std::vector<Spot> spots;
    for (std::size_t i = 0; i < numbers->size(); i += 2)
        spots.push_back({(*numbers)[i], (*numbers)[i + 1]});
    return {polyline(spots, closed)};
}

std::vector<Outline> read_polygon(const kdl::Node& node, std::size_t, Reading& reading)
{
    return read_polyline(node, true, reading);
}

std::vector<Outline> read_line(const kdl::Node& node, std::size_t, Reading& reading)
{
    return read_polyline(node, false, reading);
}

/// Passes on a finding of read_svg_path() at its place in the source; where that is not known (the text has
/// escapes or several lines), at the whole value with the place in words.
void pass_on(const Diagnostic& finding, const kdl::Value& value, std::string_view data, Reading& reading)
{
    Place place = value.place;
    std::string message = finding.message;
    if (value.text_offset) {
        place = {*value.text_offset + finding.place.offset, finding.place.length};
    } else {
        const LineColumn at = line_column(data, finding.place.offset);
        message +=
            " (line " + std::to_string(at.line) + ", column " + std::to_string(at.column) + " of the path)";
    }
    if (finding.severity == Severity::error)
        reading.report.error(place, message, finding.remedy);
    else
        reading.report.warning(place, message, finding.remedy);
}

std::vector<Outline> read_path(const kdl::Node& node, std::size_t points_left, Reading& reading)
{
    const kdl::Value& value = node.arguments.front();
    const bool good = refuse_properties(node, reading);
    const auto data = read_text(value, reading);
    if (!good || !data)
        return {};
    Diagnostics findings;
    auto outlines = read_svg_path(*data, points_left, findings);
    const auto sorted = findings.sorted();
    for (const Diagnostic& finding : sorted)
        pass_on(finding, value, *data, reading);
    if (outlines.empty() && sorted.empty())
        reading.report.warning(value.place, "this path draws nothing");
    return outlines;
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
    Shape{{"polygon", "polygon X Y X Y X Y …", 6, NodeForm::any_number}, read_polygon},
    Shape{{"line", "line X Y X Y …", 4, NodeForm::any_number}, read_line},
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

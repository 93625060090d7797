#include "host/scene/shapes/shape_reader.hpp"

#include "host/geometry/arc.hpp"
#include "host/scene/values/geometry_reader.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"

#include <cmath>

namespace kfast::scene {
namespace {

/// The values of the properties of arc and pie.
struct Shape {
    Sector sector;
    std::optional<double> inner;
};

template <double Sector::*member>
bool read_extent(const kdl::Value& value, Shape& shape, SceneContext& context)
{
    return assign(read_number(value, extents, context.report), shape.sector.*member);
}

bool read_radius(const kdl::Value& value, Shape& shape, SceneContext& context)
{
    const auto radius = read_number(value, extents, context.report);
    return assign(radius, shape.sector.radius_x) && assign(radius, shape.sector.radius_y);
}

template <double Sector::*member>
bool read_angle(const kdl::Value& value, Shape& shape, SceneContext& context)
{
    return assign(read_number(value, angles, context.report), shape.sector.*member);
}

bool read_inner(const kdl::Value& value, Shape& shape, SceneContext& context)
{
    return assign(read_number(value, extents, context.report), shape.inner);
}

constexpr PropertyRule<Shape> from_rule{"from", read_angle<&Sector::from>, ValueKind::degrees(angles), true};
constexpr PropertyRule<Shape> to_rule{"to", read_angle<&Sector::to>, ValueKind::degrees(angles), true};
constexpr PropertyRule<Shape> radius_rule{"r", read_radius, ValueKind::pixels(extents), true};

constexpr std::array arc_rules{radius_rule, from_rule, to_rule};
constexpr std::array elliptical_rules{
    PropertyRule<Shape>{"rx", read_extent<&Sector::radius_x>, ValueKind::pixels(extents), true},
    PropertyRule<Shape>{"ry", read_extent<&Sector::radius_y>, ValueKind::pixels(extents), true},
    from_rule,
    to_rule,
};
constexpr std::array pie_rules{radius_rule, from_rule, to_rule,
                               PropertyRule<Shape>{"inner", read_inner, ValueKind::pixels(extents)}};

bool within_a_turn(const kdl::Node& node, const Sector& sector, SceneContext& context)
{
    return std::abs(sector.to - sector.from) <= 360 ||
           context.report.error(node.name_span, "this " + node.name + " goes round more than once",
                                "keep from and to within 360 degrees of each other");
}

template <std::size_t count>
std::optional<Shape> read_sector(const kdl::Node& node, const std::array<PropertyRule<Shape>, count>& rules,
                                 SceneContext& context)
{
    Shape shape;
    const bool good = read_properties(node, rules, shape, context);
    const auto centre = read_spot(node, context);
    if (!good || !centre || !within_a_turn(node, shape.sector, context))
        return std::nullopt;
    shape.sector.centre = *centre;
    return shape;
}

}

std::vector<Outline> read_arc(const kdl::Node& node, std::size_t, SceneContext& context)
{
    const bool elliptical = has_property(node, "rx") || has_property(node, "ry");
    const auto shape =
        elliptical ? read_sector(node, elliptical_rules, context) : read_sector(node, arc_rules, context);
    if (!shape)
        return {};
    return {arc(shape->sector)};
}

std::vector<Outline> read_pie(const kdl::Node& node, std::size_t, SceneContext& context)
{
    const auto shape = read_sector(node, pie_rules, context);
    if (!shape)
        return {};
    return {shape->inner ? ring_piece(shape->sector, *shape->inner) : pie(shape->sector)};
}

std::vector<std::vector<PropertySchema>> arc_schema()
{
    return {schema_of(arc_rules), schema_of(elliptical_rules)};
}

std::vector<PropertySchema> pie_schema() { return schema_of(pie_rules); }

}

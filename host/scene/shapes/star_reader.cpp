#include "host/scene/shapes/shape_reader.hpp"

#include "host/geometry/shape.hpp"
#include "host/scene/values/geometry_reader.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"

namespace kfast::scene {
namespace {

constexpr Range counts{3, 1000};

/// The values of the properties of star and regular.
struct Shape {
    int count = 5; ///< of tips or sides
    double radius = 0;
    std::optional<double> inner;
    double rotation = 0;
};

bool read_count(const kdl::Value& value, Shape& shape, SceneContext& context)
{
    return assign(read_whole_number(value, counts, context.report), shape.count);
}

bool read_radius(const kdl::Value& value, Shape& shape, SceneContext& context)
{
    return assign(read_number(value, extents, context.report), shape.radius);
}

bool read_inner(const kdl::Value& value, Shape& shape, SceneContext& context)
{
    return assign(read_number(value, extents, context.report), shape.inner);
}

bool read_turn(const kdl::Value& value, Shape& shape, SceneContext& context)
{
    return assign(read_number(value, angles, context.report), shape.rotation);
}

constexpr std::array star_rules{
    PropertyRule<Shape>{"points", read_count, ValueKind::whole(counts)},
    PropertyRule<Shape>{"r", read_radius, ValueKind::pixels(extents), true},
    PropertyRule<Shape>{"inner", read_inner, ValueKind::pixels(extents)},
    PropertyRule<Shape>{"turn", read_turn, ValueKind::degrees(angles)},
};

constexpr std::array regular_rules{
    PropertyRule<Shape>{"sides", read_count, ValueKind::whole(counts), true},
    PropertyRule<Shape>{"r", read_radius, ValueKind::pixels(extents), true},
    PropertyRule<Shape>{"turn", read_turn, ValueKind::degrees(angles)},
};

}

std::vector<Outline> read_star(const kdl::Node& node, std::size_t, SceneContext& context)
{
    Shape shape;
    const bool good = read_properties(node, star_rules, shape, context);
    const auto centre = read_spot(node, context);
    if (!good || !centre)
        return {};
    return {star(*centre, shape.count, shape.radius, shape.inner.value_or(shape.radius / 2), shape.rotation)};
}

std::vector<Outline> read_regular(const kdl::Node& node, std::size_t, SceneContext& context)
{
    Shape shape;
    const bool good = read_properties(node, regular_rules, shape, context);
    const auto centre = read_spot(node, context);
    if (!good || !centre)
        return {};
    return {regular_polygon(*centre, shape.count, shape.radius, shape.rotation)};
}

std::vector<PropertySchema> star_schema() { return schema_of(star_rules); }
std::vector<PropertySchema> regular_schema() { return schema_of(regular_rules); }

}

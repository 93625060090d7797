#include "host/scene/shapes/polyline_reader.hpp"

#include "host/geometry/shape.hpp"
#include "host/geometry/spline.hpp"
#include "host/scene/values/spot_reader.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_schema.hpp"
#include "host/schema/property_rule.hpp"

namespace kfast::scene {
namespace {

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

}

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

std::vector<PropertySchema> curve_words() { return words_of(curve_rules); }

}

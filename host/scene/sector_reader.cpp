#include "host/scene/sector_reader.hpp"

#include "host/scene/node_words.hpp"
#include "host/scene/property_rule.hpp"
#include "host/scene/sector.hpp"
#include "host/scene/spot_reader.hpp"
#include "host/scene/value_reader.hpp"

#include <cmath>

namespace kfast::scene {
namespace {

/// What the properties of arc and pie give.
struct Shape {
    Sector sector;
    std::optional<double> inner;
};

template <double Sector::*member>
bool read_extent(const kdl::Value& value, Shape& shape, Reading& reading)
{
    return assign(read_number(value, extents, reading), shape.sector.*member);
}

bool read_radius(const kdl::Value& value, Shape& shape, Reading& reading)
{
    const auto radius = read_number(value, extents, reading);
    return assign(radius, shape.sector.radius_x) && assign(radius, shape.sector.radius_y);
}

template <double Sector::*member>
bool read_angle(const kdl::Value& value, Shape& shape, Reading& reading)
{
    return assign(read_number(value, angles, reading), shape.sector.*member);
}

bool read_inner(const kdl::Value& value, Shape& shape, Reading& reading)
{
    return assign(read_number(value, extents, reading), shape.inner);
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

bool within_a_turn(const kdl::Node& node, const Sector& sector, Reading& reading)
{
    return std::abs(sector.to - sector.from) <= 360 ||
           reading.report.error(node.name_place, "this " + node.name + " goes round more than once",
                                "keep from and to within 360 degrees of each other");
}

template <std::size_t count>
std::optional<Shape> read_sector(const kdl::Node& node, const std::array<PropertyRule<Shape>, count>& rules,
                                 Reading& reading)
{
    Shape shape;
    const bool good = read_properties(node, rules, shape, reading);
    const auto centre = read_spot(node, reading);
    if (!good || !centre || !within_a_turn(node, shape.sector, reading))
        return std::nullopt;
    shape.sector.centre = *centre;
    return shape;
}

}

std::vector<Outline> read_arc(const kdl::Node& node, std::size_t, Reading& reading)
{
    const bool elliptical = has_property(node, "rx") || has_property(node, "ry");
    const auto shape =
        elliptical ? read_sector(node, elliptical_rules, reading) : read_sector(node, arc_rules, reading);
    if (!shape)
        return {};
    return {arc(shape->sector)};
}

std::vector<Outline> read_pie(const kdl::Node& node, std::size_t, Reading& reading)
{
    const auto shape = read_sector(node, pie_rules, reading);
    if (!shape)
        return {};
    return {shape->inner ? ring_piece(shape->sector, *shape->inner) : pie(shape->sector)};
}

std::vector<std::vector<PropertyWords>> arc_words()
{
    return {words_of(arc_rules), words_of(elliptical_rules)};
}

std::vector<PropertyWords> pie_words() { return words_of(pie_rules); }

}

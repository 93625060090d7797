#include "host/scene/polyline_reader.hpp"

#include "host/scene/node_words.hpp"
#include "host/scene/property_rule.hpp"
#include "host/scene/shape.hpp"
#include "host/scene/spline.hpp"
#include "host/scene/spot_reader.hpp"
#include "host/scene/value_reader.hpp"

namespace kfast::scene {
namespace {

std::vector<Outline> read_polyline(const kdl::Node& node, bool closed, Reading& reading)
{
    const bool good = refuse_properties(node, reading);
    const auto spots = read_spots(node, reading);
    if (!good || !spots)
        return {};
    return {polyline(*spots, closed)};
}

bool read_closed(const kdl::Value& value, bool& closed, Reading& reading)
{
    return assign(read_flag(value, reading), closed);
}

constexpr std::array curve_rules{PropertyRule<bool>{"closed", read_closed, truth}};

}

std::vector<Outline> read_polygon(const kdl::Node& node, std::size_t, Reading& reading)
{
    return read_polyline(node, true, reading);
}

std::vector<Outline> read_line(const kdl::Node& node, std::size_t, Reading& reading)
{
    return read_polyline(node, false, reading);
}

std::vector<Outline> read_curve(const kdl::Node& node, std::size_t, Reading& reading)
{
    bool closed = false;
    const bool good = read_properties(node, curve_rules, closed, reading);
    const auto spots = read_spots(node, reading);
    if (!good || !spots)
        return {};
    return {spline(*spots, closed)};
}

std::vector<PropertyWords> curve_words() { return words_of(curve_rules); }

}

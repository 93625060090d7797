#include "host/synfig/evaluation/evaluator.hpp"

#include "host/art/animation/animated.hpp"
#include "host/art/geometry/affine.hpp"
#include "host/synfig/evaluation/spline_list.hpp"
#include "host/synfig/values/value.hpp"
#include "host/synfig/values/value_node.hpp"

#include <algorithm>
#include <cmath>

namespace kfast::synfig {

namespace {

Value spline_point(Evaluator& evaluator, const ValueNode& node, double time)
{
    SplinePoint point;
    const bool split = evaluator.truth(node, "split", time);
    point.vertex = evaluator.spot(node, node.link("point") ? "point" : "vertex", time);
    point.width = evaluator.number(node, "width", time, 1);
    point.origin = evaluator.number(node, "origin", time, 0.5);
    point.split_radius = evaluator.truth(node, "split_radius", time, split);
    point.split_angle = evaluator.truth(node, "split_angle", time, split);
    point.arriving = evaluator.spot(node, "t1", time);
    point.second = evaluator.spot(node, "t2", time);
    return {point};
}

Value width_point(Evaluator& evaluator, const ValueNode& node, double time)
{
    return {WidthPoint{evaluator.number(node, "position", time), evaluator.number(node, "width", time, 1),
                       side_of(evaluator.number(node, "side_before", time)),
                       side_of(evaluator.number(node, "side_after", time))}};
}

Value placement(Evaluator& evaluator, const ValueNode& node, double time)
{
    return {Placement{evaluator.spot(node, "offset", time), evaluator.number(node, "angle", time),
                      evaluator.number(node, "skew_angle", time),
                      evaluator.link(node, "scale", time).as<Vec2>({1, 1})}};
}

Value pair(Evaluator& evaluator, const ValueNode& node, double time, const char* first, const char* second)
{
    return {List{{evaluator.link(node, first, time), evaluator.link(node, second, time)}, false}};
}

Value composite(Evaluator& evaluator, const ValueNode& node, double time)
{
    if (node.type == "vector")
        return {Vec2{evaluator.number(node, "x", time), evaluator.number(node, "y", time)}};
    if (node.type == "color")
        return {Colour{evaluator.number(node, "r", time), evaluator.number(node, "g", time),
                       evaluator.number(node, "b", time), evaluator.number(node, "a", time, 1)}};
    if (node.type == "bline_point")
        return spline_point(evaluator, node, time);
    if (node.type == "width_point")
        return width_point(evaluator, node, time);
    if (node.type == "transformation")
        return placement(evaluator, node, time);
    if (node.link("weight"))
        return pair(evaluator, node, time, "weight", "value");
    return pair(evaluator, node, time, "first", "second");
}

/// Luma and the plane of colours as in television, with a saturation and a hue.
Value colour_by_hue(Evaluator& evaluator, const ValueNode& node, double time)
{
    const double luma = evaluator.number(node, "y_luma", time);
    const double saturation = evaluator.number(node, "saturation", time);
    const double hue = art::degree * evaluator.number(node, "hue", time);
    const double u = saturation * std::sin(hue);
    const double v = saturation * std::cos(hue);
    return {Colour{luma + v * 1.402, luma - u * 0.344136 - v * 0.714136, luma + u * 1.772,
                   evaluator.number(node, "alpha", time, 1)}};
}

Value radial_composite(Evaluator& evaluator, const ValueNode& node, double time)
{
    if (node.type == "color")
        return colour_by_hue(evaluator, node, time);
    const double radius = evaluator.number(node, "radius", time);
    const double angle = art::degree * evaluator.number(node, "theta", time);
    return {Vec2{radius * std::cos(angle), radius * std::sin(angle)}};
}

Value vector_x(Evaluator& evaluator, const ValueNode& node, double time)
{
    return {evaluator.spot(node, "vector", time).x};
}

Value vector_y(Evaluator& evaluator, const ValueNode& node, double time)
{
    return {evaluator.spot(node, "vector", time).y};
}

Value vector_angle(Evaluator& evaluator, const ValueNode& node, double time)
{
    const Vec2 spot = evaluator.spot(node, "vector", time);
    return {std::atan2(spot.y, spot.x) / art::degree};
}

Value vector_length(Evaluator& evaluator, const ValueNode& node, double time)
{
    const Vec2 spot = evaluator.spot(node, "vector", time);
    return {std::sqrt(scene::dot(spot, spot))};
}

Value reference(Evaluator& evaluator, const ValueNode& node, double time)
{
    return evaluator.link(node, "link", time);
}

Value choice(Evaluator& evaluator, const ValueNode& node, double time)
{
    return evaluator.link(node, evaluator.truth(node, "switch", time) ? "link_on" : "link_off", time);
}

Value gradient_colour(Evaluator& evaluator, const ValueNode& node, double time)
{
    const double index = evaluator.number(node, "index", time);
    const double position = evaluator.truth(node, "loop", time) ? index - std::floor(index) : index;
    return {evaluator.link(node, "gradient", time).as<Gradient>().at(position)};
}

/// The positions of the colours of a gradient are not visible in its mean.
Value unturned_gradient(Evaluator& evaluator, const ValueNode& node, double time)
{
    return evaluator.link(node, "gradient", time);
}

/// The same for stripes: one pair of them has the same mean colour as many.
Value stripes(Evaluator& evaluator, const ValueNode& node, double time)
{
    const Colour first = evaluator.link(node, "color1", time).as<Colour>();
    const Colour second = evaluator.link(node, "color2", time).as<Colour>();
    const double width = std::clamp(evaluator.number(node, "width", time, 0.5), 0.0, 1.0);
    return {Gradient{{{0, first}, {width, first}, {width, second}, {1, second}}}};
}

}

ValueLaws composite_laws()
{
    return {{"composite", composite},
            {"radial_composite", radial_composite},
            {"vectorx", vector_x},
            {"vectory", vector_y},
            {"vectorangle", vector_angle},
            {"vectorlength", vector_length},
            {"gradient_rotate", unturned_gradient},
            {"gradientcolor", gradient_colour},
            {"random", reference}, // without its noise
            {"reference", reference},
            {"greyed", reference},
            {"stripes", stripes},
            {"switch", choice}};
}

namespace {

List present_entries(Evaluator& evaluator, const ValueNode& node, double time)
{
    List list{{}, node.loop};
    for (const Entry& entry : node.entries)
        if (presence_at(entry, time).amount > 0)
            list.entries.push_back(evaluator.at(*entry.value, time));
    return list;
}

Value list(Evaluator& evaluator, const ValueNode& node, double time)
{
    return {present_entries(evaluator, node, time)};
}

Value spline(Evaluator& evaluator, const ValueNode& node, double time)
{
    return {spline_list(evaluator, node, time)};
}

Value average(Evaluator& evaluator, const ValueNode& node, double time)
{
    const List list = present_entries(evaluator, node, time);
    if (list.entries.empty())
        return {};
    Value total = list.entries.front();
    for (std::size_t i = 1; i < list.entries.size(); ++i)
        total = sum(total, list.entries[i]);
    return product(total, 1.0 / static_cast<double>(list.entries.size()));
}

Value weighted_average(Evaluator& evaluator, const ValueNode& node, double time)
{
    Value total;
    double weights = 0;
    for (const Value& entry : present_entries(evaluator, node, time).entries) {
        const auto parts = entry.as<List>().entries;
        if (parts.size() != 2)
            continue;
        const Value part = product(parts[1], parts[0].number());
        total = std::holds_alternative<std::monostate>(total.held) ? part : sum(total, part);
        weights += parts[0].number();
    }
    return weights == 0 ? total : product(total, 1 / weights);
}

/// A width point that comes or goes is blended with the line as it is without it.
Value width_points(Evaluator& evaluator, const ValueNode& node, double time)
{
    List settled{{}, node.loop};
    List all{{}, node.loop};
    for (const Entry& entry : node.entries)
        if (presence_at(entry, time).amount == 1)
            settled.entries.push_back(evaluator.at(*entry.value, time));
    for (const Entry& entry : node.entries) {
        const double amount = presence_at(entry, time).amount;
        WidthPoint point = evaluator.at(*entry.value, time).as<WidthPoint>();
        if (amount < 1)
            point.width = art::mixed(width_at(settled, point.position, point.width), point.width, amount);
        if (amount > 0)
            all.entries.push_back({point});
    }
    return {std::move(all)};
}

}

ValueLaws list_laws()
{
    return {{"static_list", list},
            {"dynamic_list", list},
            {"bline", spline},
            {"wplist", width_points},
            {"dilist", list},
            {"average", average},
            {"weighted_average", weighted_average}};
}

}

#include "host/synfig/values/value.hpp"

#include "host/art/animation/animated.hpp"
#include "host/art/geometry/affine.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <type_traits>

namespace kfast::synfig {

Colour weighted(const Colour& colour)
{
    return {colour.red * colour.alpha, colour.green * colour.alpha, colour.blue * colour.alpha, colour.alpha};
}

Colour unweighted(const Colour& colour)
{
    if (colour.alpha <= 0)
        return {0, 0, 0, 0};
    return {colour.red / colour.alpha, colour.green / colour.alpha, colour.blue / colour.alpha, colour.alpha};
}

Colour mixed(const Colour& from, const Colour& to, double share)
{
    const auto channel = [share](double left, double right) { return left + share * (right - left); };
    return {channel(from.red, to.red), channel(from.green, to.green), channel(from.blue, to.blue),
            channel(from.alpha, to.alpha)};
}

Colour Gradient::at(double position) const
{
    if (stops.empty())
        return {};
    const auto next = std::ranges::upper_bound(stops, position, {}, &GradientStop::position);
    if (next == stops.begin())
        return stops.front().colour;
    if (next == stops.end())
        return stops.back().colour;
    const GradientStop& before = *std::prev(next);
    const double share = (position - before.position) / (next->position - before.position);
    return unweighted(mixed(weighted(before.colour), weighted(next->colour), share));
}

Colour Gradient::mean() const
{
    if (stops.empty())
        return {};
    Colour total{0, 0, 0, 0};
    const auto add = [&total](const Colour& from, const Colour& to, double length) {
        const Colour middle = mixed(weighted(from), weighted(to), 0.5);
        total = {total.red + length * middle.red, total.green + length * middle.green,
                 total.blue + length * middle.blue, total.alpha + length * middle.alpha};
    };
    add(stops.front().colour, stops.front().colour, stops.front().position);
    for (std::size_t i = 1; i < stops.size(); ++i)
        add(stops[i - 1].colour, stops[i].colour, stops[i].position - stops[i - 1].position);
    add(stops.back().colour, stops.back().colour, 1 - stops.back().position);
    if (total.alpha > 0)
        return unweighted(total);
    Colour hue = stops.front().colour;
    hue.alpha = 0;
    return hue;
}

namespace {

Vec2 directed(double length, Vec2 along)
{
    const double own = std::sqrt(scene::dot(along, along));
    return own == 0 ? Vec2{length, 0} : length / own * along;
}

double length_of(Vec2 spot) { return std::sqrt(scene::dot(spot, spot)); }
double degrees_of(Vec2 spot) { return std::atan2(spot.y, spot.x) / art::degree; }

double combined(double left, double right, double factor) { return left + factor * right; }
Vec2 combined(Vec2 left, Vec2 right, double factor) { return left + factor * right; }
Colour combined(const Colour& left, const Colour& right, double factor)
{
    return {left.red + factor * right.red, left.green + factor * right.green, left.blue + factor * right.blue,
            left.alpha + factor * right.alpha};
}

/// left + factor * right
Value combined(const Value& left, const Value& right, double factor)
{
    return std::visit(
        [&](const auto& held) -> Value {
            using Held = std::decay_t<decltype(held)>;
            if constexpr (std::is_same_v<Held, double> || std::is_same_v<Held, Vec2> ||
                          std::is_same_v<Held, Colour>)
                return {combined(held, right.as<Held>(), factor)};
            else
                return left;
        },
        left.held);
}

}

Vec2 SplinePoint::leaving() const
{
    if (!split_radius && !split_angle)
        return arriving;
    if (split_radius && split_angle)
        return second;
    if (split_radius)
        return length_of(arriving) < 1e-8 ? second : directed(length_of(second), arriving);
    return directed(length_of(arriving), second);
}

art::Affine Placement::matrix() const
{
    const double first = angle * art::degree;
    const double other = (angle + skew + 90) * art::degree;
    return {scale.x * std::cos(first),
            scale.x * std::sin(first),
            scale.y * std::cos(other),
            scale.y * std::sin(other),
            offset.x,
            offset.y};
}

Placement Placement::of(const art::Affine& matrix)
{
    const Vec2 along{matrix.a, matrix.b};
    const Vec2 across{matrix.c, matrix.d};
    const double angle = degrees_of(along);
    return {{matrix.e, matrix.f},
            angle,
            std::remainder(degrees_of(across) - angle - 90, 360),
            {length_of(along), length_of(across)}};
}

Vec2 Bone::to() const { return from() + directed(length * stretch, {matrix.a, matrix.b}); }

art::Affine Bone::carrying() const { return matrix * art::grown(stretch, 1); }

double Value::number(double default_value) const
{
    if (const bool* found = std::get_if<bool>(&held))
        return *found ? 1 : 0;
    return as<double>(default_value);
}

bool Value::truth(bool default_value) const
{
    if (const double* found = std::get_if<double>(&held))
        return *found != 0;
    return as<bool>(default_value);
}

Side side_of(double number)
{
    return number >= 0 && number <= static_cast<double>(Side::inner_peak)
               ? static_cast<Side>(static_cast<int>(number))
               : Side::flat;
}

Value sum(const Value& left, const Value& right) { return combined(left, right, 1); }
Value difference(const Value& left, const Value& right) { return combined(left, right, -1); }
Value product(const Value& value, double factor) { return combined(value, value, factor - 1); }

double width_at(const List& points, double position, double default_value)
{
    const WidthPoint* before = nullptr;
    const WidthPoint* behind = nullptr;
    for (const Value& entry : points.entries) {
        const WidthPoint* point = std::get_if<WidthPoint>(&entry.held);
        if (!point)
            continue;
        if (point->position <= position && (!before || point->position >= before->position))
            before = point;
        if (point->position >= position && (!behind || point->position < behind->position))
            behind = point;
    }
    if (!before || !behind)
        return before ? before->width : behind ? behind->width : default_value;
    const double span = behind->position - before->position;
    return span <= 0 ? before->width
                     : art::mixed(before->width, behind->width, (position - before->position) / span);
}

}

#include "host/synfig/values/gradient.hpp"

#include <algorithm>
#include <iterator>

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

}

#include "host/art/document/value_distance.hpp"

#include <algorithm>
#include <cmath>

namespace kfast::art {
namespace {

using scene::Curve;
using scene::Outline;
using scene::Vec2;

Vec2 between(Vec2 from, Vec2 to, double share) { return from + share * (to - from); }

/// Walks through the points of a tweened drawing, lines as cubics.
class Points {
public:
    explicit Points(const OnWay<Drawing>& way) : way_{way} {}

    Vec2 begin(std::size_t outline) const
    {
        return between(way_.from.outlines[outline].from, way_.to.outlines[outline].from, way_.share);
    }

    Curve curve(std::size_t outline, std::size_t index) const
    {
        const Curve from = cubic(way_.from.outlines[outline], index);
        const Curve to = cubic(way_.to.outlines[outline], index);
        return {true, between(from.c1, to.c1, way_.share), between(from.c2, to.c2, way_.share),
                between(from.to, to.to, way_.share)};
    }

private:
    static Curve cubic(const Outline& outline, std::size_t index)
    {
        return as_cubic(index == 0 ? outline.from : outline.curves[index - 1].to, outline.curves[index]);
    }

    const OnWay<Drawing>& way_;
};

/// Calls visit(spot, spot) with each pair of points.
template <typename Visit>
void every_pair(const OnWay<Drawing>& left, const OnWay<Drawing>& right, const Visit& visit)
{
    const Points lefts{left};
    const Points rights{right};
    for (std::size_t i = 0; i < left.from.outlines.size(); ++i) {
        visit(lefts.begin(i), rights.begin(i));
        for (std::size_t j = 0; j < left.from.outlines[i].curves.size(); ++j) {
            const Curve one = lefts.curve(i, j);
            const Curve other = rights.curve(i, j);
            visit(one.c1, other.c1);
            visit(one.c2, other.c2);
            visit(one.to, other.to);
        }
    }
}

Rgb value_of(const OnWay<Rgb>& way) { return mixed(way.from, way.to, way.share); }
Rgb difference(const Rgb& left, const Rgb& right)
{
    return {left.red - right.red, left.green - right.green, left.blue - right.blue};
}
double dot(const Rgb& left, const Rgb& right)
{
    return left.red * right.red + left.green * right.green + left.blue * right.blue;
}

double share(double along, double square) { return square > 0 ? along / square : 0; }

}

double distance(const OnWay<double>& left, const OnWay<double>& right)
{
    return std::abs(mixed(left.from, left.to, left.share) - mixed(right.from, right.to, right.share));
}

double distance(const OnWay<Rgb>& left, const OnWay<Rgb>& right)
{
    const Rgb apart = difference(value_of(left), value_of(right));
    return std::max({std::abs(apart.red), std::abs(apart.green), std::abs(apart.blue)});
}

double distance(const OnWay<Drawing>& left, const OnWay<Drawing>& right)
{
    double max = 0;
    every_pair(left, right,
               [&](Vec2 one, Vec2 other) { max = std::max(max, dot(one - other, one - other)); });
    return std::sqrt(max);
}

double nearest_share(const double& from, const double& to, const OnWay<double>& value)
{
    return from == to ? 0 : (mixed(value.from, value.to, value.share) - from) / (to - from);
}

double nearest_share(const Rgb& from, const Rgb& to, const OnWay<Rgb>& value)
{
    const Rgb way = difference(to, from);
    return share(dot(difference(value_of(value), from), way), dot(way, way));
}

double nearest_share(const Drawing& from, const Drawing& to, const OnWay<Drawing>& value)
{
    std::vector<Vec2> ways;
    double square = 0;
    every_pair({from, from, 0}, {to, to, 0}, [&](Vec2 begin, Vec2 end) {
        ways.push_back(end - begin);
        square += dot(end - begin, end - begin);
    });
    double along = 0;
    std::size_t next = 0;
    every_pair({from, from, 0}, value,
               [&](Vec2 begin, Vec2 spot) { along += dot(spot - begin, ways[next++]); });
    return share(along, square);
}

}

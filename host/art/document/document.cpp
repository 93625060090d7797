#include "host/art/document/document.hpp"

#include "host/art/geometry/curves.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kfast::art {

bool operator==(const Node& left, const Node& right)
{
    return left.name == right.name && left.transform == right.transform && left.opacity == right.opacity &&
           left.shown == right.shown && left.parent_tag == right.parent_tag && left.content == right.content;
}

double period_at(const Dashes& dashes, double time)
{
    double period = 0;
    for (const Channel& length : dashes.lengths)
        period += std::max(0.0, length.at(time));
    return period;
}

bool has_still_lengths(const Dashes& dashes)
{
    return std::ranges::all_of(dashes.lengths, [](const Channel& length) { return length.is_still(); });
}

namespace {

double direction_along(const scene::Outline& path, double share)
{
    constexpr double beside = 1e-4;
    const scene::Vec2 way = spot_along(path, share + beside) - spot_along(path, share - beside);
    return std::atan2(way.y, way.x) * 180 / std::numbers::pi;
}

Affine place_at(const Transform& transform, double time)
{
    if (!transform.path || transform.path->path.outlines.empty())
        return moved(transform.x.at(time), transform.y.at(time));
    const scene::Outline& path = transform.path->path.outlines.front();
    const double share = std::clamp(transform.path->share.at(time), 0.0, 1.0);
    const scene::Vec2 place = spot_along(path, share);
    const Affine move = moved(place.x, place.y);
    return transform.path->turns ? move * turned(direction_along(path, share)) : move;
}

}

Affine shape_at(const Transform& transform, double time)
{
    const double skew = transform.skew.at(time);
    const Affine skewing =
        skew != 0 ? skewed(std::clamp(skew, -steepest_skew, steepest_skew), transform.skew_axis.at(time))
                  : Affine{};
    return turned(transform.rotate.at(time)) * grown(transform.scale_x.at(time), transform.scale_y.at(time)) *
           skewing;
}

Affine matrix_at(const Transform& transform, double time)
{
    return place_at(transform, time) * shape_at(transform, time) *
           moved(-transform.anchor_x.at(time), -transform.anchor_y.at(time));
}

Affine matrix_of(const Copies& copies, int number)
{
    const double scale = std::pow(copies.scale, number);
    return moved(number * copies.x, number * copies.y) * turned(number * copies.rotation) *
           grown(scale, scale);
}

}

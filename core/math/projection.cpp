#include "core/math/projection.hpp"

#include "core/bytes/op_counter.hpp"
#include "core/math/fixed.hpp"
#include "core/math/point.hpp"

#include <algorithm>
#include <bit>

namespace kfast {

namespace {

constexpr int nearness_bits = 24;

/// By how many bits a distance of at least 1 is too long for a divisor.
int excess_bits(std::int64_t distance)
{
    return std::max(0, static_cast<int>(std::bit_width(static_cast<std::uint64_t>(distance))) - 32);
}

/// Farther from the middle, points are clamped: projected, they are out of sight, or too far away to matter.
std::int64_t within_reach(std::int64_t distance)
{
    constexpr std::int64_t farthest = std::int64_t{1} << 34;
    return std::clamp(distance, -farthest, farthest);
}

std::int64_t times(std::int64_t value, std::int64_t nearness)
{
    return rounded_shift(value * nearness, nearness_bits);
}

}

Projection::Projection(const Space& space, const Camera& camera)
    : see_{plain_function<&Projection::seen>}, space_{space}, camera_{camera}
{
    space_.plane.x0 -= camera.x;
    space_.plane.y0 -= camera.y;
}

Point Projection::seen(Point point) const
{
    count_op(Op::projected_point);
    const Affine& plane = space_.plane;
    const std::int64_t x = sum_of_products(plane.xx, point.x.raw(), plane.xy, point.y.raw()) + plane.x0;
    const std::int64_t y = sum_of_products(plane.yx, point.x.raw(), plane.yy, point.y.raw()) + plane.y0;
    const std::int64_t near = nearness(point);
    return clamped_point(camera_.x + times(within_reach(x), near), camera_.y + times(within_reach(y), near));
}

/// d / (d - z) in Q24, 0 … 16.
std::int64_t Projection::nearness(Point point) const
{
    const std::int64_t z = sum_of_products(space_.zx, point.x.raw(), space_.zy, point.y.raw()) + space_.z0;
    const std::int64_t min = std::max<std::int64_t>(camera_.distance >> 4, 1);
    const std::int64_t left = std::max(camera_.distance - z, min);
    const int shift = excess_bits(left);
    const auto divisor = static_cast<std::uint32_t>(left >> shift);
    return quotient((camera_.distance >> shift << nearness_bits) + divisor / 2, divisor);
}

// With n = d / (d - z), a point x is seen at n x, and n changes by n^2 / d for each step in z: the seen x
// changes by n (dx + n x / d dz).
std::int32_t Projection::scale_factor_at(Point point) const
{
    const std::int64_t near = nearness(point);
    const Point on_panel = seen(point);
    const auto seen_x = static_cast<std::int64_t>(on_panel.x.raw()) - camera_.x;
    const auto seen_y = static_cast<std::int64_t>(on_panel.y.raw()) - camera_.y;
    const int shift = excess_bits(camera_.distance);
    const auto distance = static_cast<std::uint32_t>(camera_.distance >> shift);
    const auto grown = [&](std::int32_t own, std::int64_t at, std::int32_t depth) {
        return clamped_factor(times(own + within_reach(quotient(at * depth >> shift, distance)), near));
    };
    const Affine& plane = space_.plane;
    return Affine{.xx = grown(plane.xx, seen_x, space_.zx),
                  .xy = grown(plane.xy, seen_x, space_.zy),
                  .yx = grown(plane.yx, seen_y, space_.zx),
                  .yy = grown(plane.yy, seen_y, space_.zy)}
        .scale_factor();
}

Projection Projection::in_front(Fixed z) const
{
    const auto shift = [z](std::int32_t factor) { return sum_of_products(factor, z.raw(), 0, 0); };
    Projection moved = *this;
    moved.space_.plane.x0 += shift(space_.xz);
    moved.space_.plane.y0 += shift(space_.yz);
    moved.space_.z0 += shift(space_.zz);
    return moved;
}

std::int32_t Projection::scale_factor_facing(Point point) const
{
    const auto length = [](std::int64_t x, std::int64_t y, std::int64_t z) {
        return std::uint64_t{square_root(static_cast<std::uint64_t>(x * x + y * y + z * z))};
    };
    const Affine& plane = space_.plane;
    const std::uint64_t area = length(plane.xx, plane.yx, space_.zx) * length(plane.xy, plane.yy, space_.zy);
    return clamped_factor(times(square_root(area), nearness(point)));
}

int ViewProjection::pieces_of(const Segment& segment) const
{
    if (segment.kind == Segment::Kind::line)
        return 1;
    const ViewProjection& seen = *this;
    const int needed = projection_ == nullptr
                           ? pieces_for(segment)
                           : pieces_for({segment.kind, seen(segment.from), seen(segment.c1), seen(segment.c2),
                                         seen(segment.to)});
    return coarser(needed, coarseness_);
}

}

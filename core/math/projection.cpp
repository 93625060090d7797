#include "core/math/projection.hpp"

#include "core/bytes/function_ref.hpp"
#include "core/bytes/op_counter.hpp"
#include "core/features.hpp"
#include "core/math/fixed.hpp"
#include "core/math/point.hpp"

#include <algorithm>
#include <bit>

namespace kfast {

namespace {

/// A vector of x, y and z, mapped without the shift; rounded to nearest, halves up.
struct Triple {
    std::int64_t x;
    std::int64_t y;
    std::int64_t z;
};

[[gnu::noinline]] Triple turned(const Space& space, const Triple& from)
{
    const auto sum = [&from](std::int32_t p, std::int32_t q, std::int32_t r) {
        return rounded_shift(p * from.x + q * from.y + r * from.z, 16);
    };
    return {sum(space.plane.xx, space.plane.xy, space.xz), sum(space.plane.yx, space.plane.yy, space.yz),
            sum(space.zx, space.zy, space.zz)};
}

}

Space product(const Space& outer, const Space& inner, const Features& features)
{
    if (outer.is_flat() && inner.is_flat())
        return {.plane = outer.plane * inner.plane,
                .zz = clamped_factor(sum_of_products(outer.zz, inner.zz, 0, 0))};
    return features.depth->product(outer, inner);
}

Space product_in_depth(const Space& outer, const Space& inner)
{
    const Triple x = turned(outer, {inner.plane.xx, inner.plane.yx, inner.zx});
    const Triple y = turned(outer, {inner.plane.xy, inner.plane.yy, inner.zy});
    const Triple z = turned(outer, {inner.xz, inner.yz, inner.zz});
    const Triple shift = turned(outer, {inner.plane.x0, inner.plane.y0, inner.z0});
    return {.plane = {.xx = clamped_factor(x.x),
                      .xy = clamped_factor(y.x),
                      .yx = clamped_factor(x.y),
                      .yy = clamped_factor(y.y),
                      .x0 = outer.plane.x0 + shift.x,
                      .y0 = outer.plane.y0 + shift.y},
            .xz = clamped_factor(z.x),
            .yz = clamped_factor(z.y),
            .zx = clamped_factor(x.z),
            .zy = clamped_factor(y.z),
            .zz = clamped_factor(z.z),
            .z0 = outer.z0 + shift.z};
}

namespace {

/// A unit vector's component in Q30 times a scale in 1/2^20, as a Q16 factor.
std::int32_t scaled_component(std::int32_t component, std::int32_t scale)
{
    return multiply(component, scale, 34);
}

struct TurnedAxis : UnitVector {
    explicit TurnedAxis(FineAngle angle) : UnitVector{kfast::cosine(angle), kfast::sine(angle)} {}
};

/// The product of two components of unit vectors.
std::int32_t product(std::int32_t a, std::int32_t b) { return multiply(a, b, 30); }

}

Space upright(const Turning& turning)
{
    const TurnedAxis z{turning.z};
    return {.plane = {.xx = scaled_component(z.cosine, turning.scale_x),
                      .xy = scaled_component(-z.sine, turning.scale_y),
                      .yx = scaled_component(z.sine, turning.scale_x),
                      .yy = scaled_component(z.cosine, turning.scale_y)}};
}

Space tilted(const Turning& turning)
{
    const TurnedAxis x{turning.x};
    const TurnedAxis y{turning.y};
    const TurnedAxis z{turning.z};
    const auto [scale_x, scale_y] = std::pair{turning.scale_x, turning.scale_y};
    const std::int32_t deep_x = -product(y.sine, z.cosine); // where rotations about z and y take x and y in z
    const std::int32_t deep_y = product(y.sine, z.sine);
    return {.plane = {.xx = scaled_component(product(y.cosine, z.cosine), scale_x),
                      .xy = scaled_component(-product(y.cosine, z.sine), scale_y),
                      .yx = scaled_component(product(x.cosine, z.sine) - product(x.sine, deep_x), scale_x),
                      .yy = scaled_component(product(x.cosine, z.cosine) - product(x.sine, deep_y), scale_y)},
            .xz = q16_of_q30(y.sine),
            .yz = q16_of_q30(-product(x.sine, y.cosine)),
            .zx = scaled_component(product(x.sine, z.sine) + product(x.cosine, deep_x), scale_x),
            .zy = scaled_component(product(x.sine, z.cosine) + product(x.cosine, deep_y), scale_y),
            .zz = q16_of_q30(product(x.cosine, y.cosine))};
}

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

// Placements in space: products and turns, for each item; projection.cpp is for each point.

#include "core/math/projection.hpp"

#include "core/features.hpp"
#include "core/math/fixed.hpp"
#include "core/math/point.hpp"

namespace kfast {

namespace {

/// What three numbers in the place of x, y and z come to, without the shift; rounded to nearest, halves up.
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

/// Of two components of unit vectors.
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
    const std::int32_t deep_x = -product(y.sine, z.cosine); // where turns about z and y take x and y in z
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

}

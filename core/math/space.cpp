#include "core/math/space.hpp"

#include "core/feature_code.hpp"
#include "core/math/fixed.hpp"

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
        return (p * from.x + q * from.y + r * from.z + Fixed::one / 2) >> 16;
    };
    return {sum(space.plane.xx, space.plane.xy, space.xz), sum(space.plane.yx, space.plane.yy, space.yz),
            sum(space.zx, space.zy, space.zz)};
}

}

Space product(const Space& outer, const Space& inner, const Features& features)
{
    if (outer.is_flat() && inner.is_flat())
        return {.plane = outer.plane * inner.plane,
                .zz = held_factor(sum_of_products(outer.zz, inner.zz, 0, 0))};
    return features.depth->product(outer, inner);
}

Space product_in_depth(const Space& outer, const Space& inner)
{
    const Triple x = turned(outer, {inner.plane.xx, inner.plane.yx, inner.zx});
    const Triple y = turned(outer, {inner.plane.xy, inner.plane.yy, inner.zy});
    const Triple z = turned(outer, {inner.xz, inner.yz, inner.zz});
    const Triple shift = turned(outer, {inner.plane.x0, inner.plane.y0, inner.z0});
    return {.plane = {.xx = held_factor(x.x),
                      .xy = held_factor(y.x),
                      .yx = held_factor(x.y),
                      .yy = held_factor(y.y),
                      .x0 = outer.plane.x0 + shift.x,
                      .y0 = outer.plane.y0 + shift.y},
            .xz = held_factor(z.x),
            .yz = held_factor(z.y),
            .zx = held_factor(x.z),
            .zy = held_factor(y.z),
            .zz = held_factor(z.z),
            .z0 = outer.z0 + shift.z};
}

}

#include "core/space.hpp"

#include "core/sum_of_products.hpp"

namespace kfast {
namespace {

/// p a + q b + r c in Q16, rounded to nearest, halves up.
std::int64_t sum(std::int32_t p, std::int64_t a, std::int32_t q, std::int64_t b, std::int32_t r,
                 std::int64_t c)
{
    return (p * a + q * b + r * c + Fixed::one / 2) >> 16;
}

}

Space operator*(const Space& outer, const Space& inner)
{
    if (outer.is_flat() && inner.is_flat())
        return {.plane = outer.plane * inner.plane,
                .zz = held_factor(sum_of_products(outer.zz, inner.zz, 0, 0))};
    const Affine& o = outer.plane;
    const Affine& i = inner.plane;
    return {.plane = {.xx = held_factor(sum(o.xx, i.xx, o.xy, i.yx, outer.xz, inner.zx)),
                      .xy = held_factor(sum(o.xx, i.xy, o.xy, i.yy, outer.xz, inner.zy)),
                      .yx = held_factor(sum(o.yx, i.xx, o.yy, i.yx, outer.yz, inner.zx)),
                      .yy = held_factor(sum(o.yx, i.xy, o.yy, i.yy, outer.yz, inner.zy)),
                      .x0 = o.x0 + sum(o.xx, i.x0, o.xy, i.y0, outer.xz, inner.z0),
                      .y0 = o.y0 + sum(o.yx, i.x0, o.yy, i.y0, outer.yz, inner.z0)},
            .xz = held_factor(sum(o.xx, inner.xz, o.xy, inner.yz, outer.xz, inner.zz)),
            .yz = held_factor(sum(o.yx, inner.xz, o.yy, inner.yz, outer.yz, inner.zz)),
            .zx = held_factor(sum(outer.zx, i.xx, outer.zy, i.yx, outer.zz, inner.zx)),
            .zy = held_factor(sum(outer.zx, i.xy, outer.zy, i.yy, outer.zz, inner.zy)),
            .zz = held_factor(sum(outer.zx, inner.xz, outer.zy, inner.yz, outer.zz, inner.zz)),
            .z0 = outer.z0 + sum(outer.zx, i.x0, outer.zy, i.y0, outer.zz, inner.z0)};
}

}

#pragma once

#include "core/features.hpp"
#include "core/math/affine.hpp"

#include <cstdint>

namespace kfast {

/// A map of space, on its way from an item's own plane, z = 0, to the panel. z points at the viewer.
struct Space {
    Affine plane; ///< x' and y' of the points with z = 0
    // x' += xz z, y' += yz z, z' = zx x + zy y + zz z + z0
    std::int32_t xz = 0; ///< Q16, as the next four
    std::int32_t yz = 0;
    std::int32_t zx = 0;
    std::int32_t zy = 0;
    std::int32_t zz = Fixed::one;
    std::int64_t z0 = 0; ///< in 1/65536 px

    /// Whether z plays no part in it: `plane` is all that there is to say.
    bool is_flat() const { return xz == 0 && yz == 0 && zx == 0 && zy == 0 && z0 == 0; }
};

/// First `inner`, then `outer`; rounded and held as the product of two Affine. `features` has depth if one of
/// them is not flat.
Space product(const Space& outer, const Space& inner, const Features& features);
/// The same of any two.
Space product_in_depth(const Space& outer, const Space& inner);

}

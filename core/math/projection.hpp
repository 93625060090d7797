#pragma once

#include "core/features.hpp"
#include "core/math/affine.hpp"
#include "core/math/angle.hpp"
#include "core/math/flatten.hpp"
#include "core/math/point.hpp"

#include <cstdint>

namespace kfast {

/// A map of space, from an item's own plane, z = 0, towards the panel. z points at the viewer.
struct Space {
    Affine plane; ///< x' and y' of the points with z = 0
    // x' += xz z, y' += yz z, z' = zx x + zy y + zz z + z0
    std::int32_t xz = 0; ///< Q16, as the next four
    std::int32_t yz = 0;
    std::int32_t zx = 0;
    std::int32_t zy = 0;
    std::int32_t zz = Fixed::one;
    std::int64_t z0 = 0; ///< in 1/65536 px

    /// Whether z plays no part in it: `plane` is the whole map.
    bool is_flat() const { return xz == 0 && yz == 0 && zx == 0 && zy == 0 && z0 == 0; }
};

/// First `inner`, then `outer`; rounded and clamped as the product of two Affine. `features` has depth if one
/// of them is not flat.
Space product(const Space& outer, const Space& inner, const Features& features);
/// The same for any two.
Space product_in_depth(const Space& outer, const Space& inner);

/// How an item is scaled and rotated about its pivot: first scaled, then rotated about z, y and x.
struct Turning {
    FineAngle x;
    FineAngle y;
    FineAngle z;
    std::int32_t scale_x = 0; ///< in 1/2^20
    std::int32_t scale_y = 0;
};

/// The map if it is rotated only about z. Every factor is rounded to Q16 once, as by tilted().
Space upright(const Turning& turning);
Space tilted(const Turning& turning);

/// Where the viewer is: in front of the middle of the panel.
struct Camera {
    std::int64_t x; ///< in 1/65536 px of the panel, as the others
    std::int64_t y;
    std::int64_t distance; ///< at least 1, less than 2^44
};

/// How the viewer sees the plane of an item: c + ((x, y) - c) d / (d - z), where c is opposite to the viewer
/// and d the distance. d - z is clamped to d / 16 or more.
class Projection {
public:
    Projection(const Space& space, const Camera& camera);

    /// Projects to the panel, within 1/64 px for points that are seen less than 512 px from its middle.
    Point operator()(Point point) const { return see_(*this, point); }
    /// The scale of lengths around `point`, in Q16: the square root of the scale of areas, rounded down.
    std::int32_t scale_factor_at(Point point) const;

    // Only wire frames need these: see PosedWires.
    /// The projection of the plane that is `z` in front of the item's, along the item's own z.
    [[gnu::cold]] Projection in_front(Fixed z) const;
    /// The scale of lengths that face the viewer at `point`, however the plane is rotated, in Q16: the mean
    /// of those along x and along y of the item.
    [[gnu::cold]] std::int32_t scale_factor_facing(Point point) const;

private:
    Point seen(Point point) const;
    std::int64_t nearness(Point point) const;

    /// The function that works on it: linked only with what makes one.
    Point (*see_)(const Projection&, Point);
    Space space_;
    Camera camera_;
};

/// How the points of an object are seen: as they are, or projected.
class ViewProjection {
public:
    /// As they are if `projection`, which must outlive it, is null. `coarseness` is how often the pieces of
    /// curves are made twice as long as the precision requires.
    ViewProjection(const Projection* projection, int coarseness)
        : projection_{projection}, coarseness_{coarseness}
    {
    }

    bool is_flat() const { return projection_ == nullptr; }
    Point operator()(Point at) const { return projection_ == nullptr ? at : (*projection_)(at); }
    /// The number of straight pieces that replace `segment`. The pieces are projected: the projection of a
    /// curve is not the curve of the projected points.
    int pieces_of(const Segment& segment) const;
    int coarseness() const { return coarseness_; }

private:
    const Projection* projection_;
    int coarseness_;
};

}

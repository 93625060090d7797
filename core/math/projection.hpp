#pragma once

#include "core/math/point.hpp"
#include "core/math/space.hpp"

#include <cstdint>

namespace kfast {

/// Where the viewer is: in front of the middle of the panel.
struct Camera {
    std::int64_t x; ///< in 1/65536 px of the panel, as the others
    std::int64_t y;
    std::int64_t distance; ///< at least 1, less than 2^44
};

/// How the viewer sees the plane of an item: c + ((x, y) - c) d / (d - z), where c is opposite to the viewer
/// and d the distance. d - z is held at d / 16 or more.
class Projection {
public:
    Projection(const Space& space, const Camera& camera);

    /// To the panel, within 1/64 px for points that are seen less than 512 px from its middle.
    Point operator()(Point point) const { return see_(*this, point); }
    /// By what lengths around `point` grow, in Q16: the square root of what areas grow by, rounded down.
    std::int32_t scale_factor_at(Point point) const;

    // Only wire frames need these: see PosedWires.
    /// Of the plane that lies `z` in front of the item's, by its own z.
    [[gnu::cold]] Projection in_front(Fixed z) const;
    /// By what lengths grow that face the viewer at `point`, however the plane is turned, in Q16: the mean of
    /// what those along x and along y of the item do.
    [[gnu::cold]] std::int32_t scale_factor_facing(Point point) const;

private:
    Point seen(Point point) const;
    std::int64_t nearness(Point point) const;

    /// What works on it: linked only with what makes one.
    Point (*see_)(const Projection&, Point);
    Space space_;
    Camera camera_;
};

}

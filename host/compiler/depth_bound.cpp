#include "host/compiler/depth_bound.hpp"

#include "core/angle.hpp"
#include "host/compiler/track_peak.hpp"

#include <algorithm>
#include <cmath>

namespace kfast {
namespace {

constexpr double nearest_share = 1.0 / 16; ///< of the camera's distance: nothing is seen from nearer

// Not std::hypot, which platforms round differently.
double length(double x, double y) { return std::sqrt(x * x + y * y); }

/// The sine of the angle that `rotation` gets to at most, or 1 if that is a quarter turn or more.
double tilt(const std::vector<scene::Track>& tracks, Property rotation)
{
    const double peak = std::min<double>(track_peak(tracks, rotation, 0), BinaryAngle::quarter_turn);
    const auto angle = BinaryAngle::from_raw(static_cast<std::int32_t>(std::ceil(peak)));
    return static_cast<double>(sine(angle)) / one_q30;
}

}

Depth depth_inside(const Depth& outside, const scene::Item& item, const Extents& extents)
{
    Depth inside = outside;
    const TrackRange z = track_range(item.tracks, Property::z, 0);
    inside.nearest += (outside.is_turned ? std::max(-z.least, z.most) : z.most) / 16;
    const double tilt_x = tilt(item.tracks, Property::rotation_x);
    const double tilt_y = tilt(item.tracks, Property::rotation_y);
    if (tilt_x == 0 && tilt_y == 0)
        return inside;
    const Reach reach = extents.from_pivot(item);
    inside.nearest += reach.y * tilt_x + reach.x * tilt_y;
    inside.is_turned = true;
    return inside;
}

// A length that points at the viewer is seen as well, beside the centre of the canvas: at the distance s from
// it by s / camera as much as one across.
double perspective_bound(const Depth& depth, const scene::Scene& scene)
{
    const double distance = std::max(scene.camera - depth.nearest, scene.camera * nearest_share);
    const double corner = length(scene.canvas.width, scene.canvas.height) / 2;
    const double slant = depth.is_turned ? length(1, corner / scene.camera) : 1;
    return scene.camera / distance * slant;
}

}

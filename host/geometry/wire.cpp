#include "host/geometry/wire.hpp"

#include "host/geometry/coordinate.hpp"

#include <algorithm>

namespace kfast::scene {
namespace {

Segment line_to(Point to) { return {.cubic = false, .c1 = {}, .c2 = {}, .to = to}; }

}

bool in_range(const Wire& wire)
{
    return std::ranges::all_of(
        wire, [](const Vec3& spot) { return in_range(spot.x) && in_range(spot.y) && in_range(spot.z); });
}

WireStroke quantized(const Wire& wire)
{
    const auto flat = [](const Vec3& spot) { return Point{to_sixteenths(spot.x), to_sixteenths(spot.y)}; };
    const auto depth = [](const Vec3& spot) { return Point{to_sixteenths(spot.z), 0}; };
    WireStroke stroke{.flat = {flat(wire.front()), {}}, .depths = {depth(wire.front()), {}}};
    for (auto spot = wire.begin() + 1; spot != wire.end(); ++spot) {
        stroke.flat.segments.push_back(line_to(flat(*spot)));
        stroke.depths.segments.push_back(line_to(depth(*spot)));
    }
    return stroke;
}

}

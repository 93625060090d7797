#include "host/geometry/star.hpp"

#include "host/geometry/shape.hpp"
#include "host/geometry/unit_circle.hpp"

#include <vector>

namespace kfast::scene {
namespace {

constexpr double twelve_o_clock = -90;

}

Outline star(Vec2 centre, int tips, double outer, double inner, double rotation)
{
    std::vector<Vec2> spots;
    spots.reserve(static_cast<std::size_t>(2 * tips));
    for (int i = 0; i < 2 * tips; ++i)
        spots.push_back(centre + (i % 2 == 0 ? outer : inner) *
                                     on_unit_circle(twelve_o_clock + rotation + 180.0 * i / tips));
    return polyline(spots, true);
}

Outline regular_polygon(Vec2 centre, int corners, double radius, double rotation)
{
    std::vector<Vec2> spots;
    spots.reserve(static_cast<std::size_t>(corners));
    for (int i = 0; i < corners; ++i)
        spots.push_back(centre + radius * on_unit_circle(twelve_o_clock + rotation + 360.0 * i / corners));
    return polyline(spots, true);
}

}

#include "host/lottie/drawings/polystar.hpp"

#include "host/geometry/arc.hpp"

#include <numbers>

namespace kfast::lottie {
namespace {

using scene::Vec2;

struct Tip {
    Vec2 at;
    Vec2 handle; ///< of what leaves `at`; that of what arrives is the opposite
};

Tip tip(const Polystar& star, int index)
{
    const int count = star.inner ? 2 * star.tips : star.tips;
    const Ring& ring = star.inner && index % 2 != 0 ? *star.inner : star.outer;
    const double way = star.counterclockwise ? -1 : 1;
    const Vec2 direction = scene::on_unit_circle(star.rotation - 90 + way * 360.0 * (index % count) / count);
    const double length = ring.roundness * std::numbers::pi * ring.radius / 2 / star.tips;
    return {star.centre + ring.radius * direction, way * length * Vec2{-direction.y, direction.x}};
}

}

scene::Outline outline_of(const Polystar& star, bool is_round)
{
    const int count = star.inner ? 2 * star.tips : star.tips;
    Tip from = tip(star, 0);
    scene::Outline outline{from.at, {}, true};
    for (int i = 1; i <= count; ++i) {
        const Tip to = tip(star, i);
        outline.curves.push_back(is_round ? scene::cubic_to(from.at + from.handle, to.at - to.handle, to.at)
                                          : scene::line_to(to.at));
        from = to;
    }
    return outline;
}

}

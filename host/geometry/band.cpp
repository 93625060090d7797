#include "host/geometry/band.hpp"

#include <algorithm>
#include <cstddef>

namespace kfast::scene {
namespace {

/// The unit normal to the left of the direction from `a` to `b`.
Vec2 left_of(Vec2 a, Vec2 b)
{
    const Vec2 way = b - a;
    return (1 / distance(a, b)) * Vec2{way.y, -way.x};
}

/// Where the band is 1 px wide on either side of a node between two segments, of which these are the normals.
Vec2 mitre(Vec2 before, Vec2 after)
{
    const Vec2 sum = before + after;
    const double size = distance({}, sum);
    if (size < 1e-6) // the band turns back on itself
        return before;
    return std::min(2 / size, 2.0) / size * sum;
}

Vec2 normal_at(std::span<const Vec2> nodes, std::size_t i)
{
    const std::size_t last = nodes.size() - 1;
    if (i == 0)
        return left_of(nodes[0], nodes[1]);
    if (i == last)
        return left_of(nodes[last - 1], nodes[last]);
    return mitre(left_of(nodes[i - 1], nodes[i]), left_of(nodes[i], nodes[i + 1]));
}

}

BandSides sides_of_band(std::span<const Vec2> nodes, std::span<const double> widths)
{
    BandSides sides;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Vec2 away = widths[i] / 2 * normal_at(nodes, i);
        sides.left.push_back(nodes[i] + away);
        sides.right.push_back(nodes[i] - away);
    }
    return sides;
}

}

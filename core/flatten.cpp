#include "core/flatten.hpp"

#include <algorithm>

namespace kfast {
namespace {

constexpr int spare_bits = 2; ///< the sum of four coordinates has these more

/// |a - 2 b + c| in 1/16384 px, at most 1/8 too much.
std::int32_t bend(Point a, Point b, Point c)
{
    const auto of = [](Fixed from, Fixed by, Fixed to) {
        return ((from - by).raw() >> spare_bits) + ((to - by).raw() >> spare_bits);
    };
    return rough_length(of(a.x, b.x, c.x), of(a.y, b.y, c.y));
}

}

int halvings_for(const Segment& segment)
{
    if (segment.kind == Segment::Kind::line)
        return 0;
    const std::int32_t bent =
        std::max(bend(segment.from, segment.c1, segment.c2), bend(segment.c1, segment.c2, segment.to));
    int halvings = 0;
    for (std::int32_t limit = (flatness.raw() * 4 / 3) >> spare_bits; bent > limit; limit *= 4)
        if (++halvings == most_halvings)
            break;
    return halvings;
}

}

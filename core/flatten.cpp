#include "core/flatten.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>

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

template <class Word>
CubicSteps<Word>::CubicSteps(int halvings, Fixed c1, Fixed c2, Fixed to)
{
    if constexpr (std::is_same_v<FractionBits, int>)
        fraction_bits_ = 3 * halvings;
    const auto word = [](Fixed value) { return static_cast<Word>(value.raw()); };
    const Word slope = 3 * word(c1);
    const Word square = 3 * (word(c2) - 2 * word(c1));
    const Word cube = word(to) - 3 * (word(c2) - word(c1));
    const auto of_n = [this, halvings](Word value, int power) {
        return value << (fraction_bits_ - power * halvings);
    };
    value_ = Word{1} << (fraction_bits_ - 1);
    first_ = of_n(slope, 1) + of_n(square, 2) + of_n(cube, 3);
    third_ = 6 * of_n(cube, 3);
    second_ = 2 * of_n(square, 2) + third_;
}

template class CubicSteps<std::uint32_t>;
template class CubicSteps<std::uint64_t>;

bool is_small(const Segment& cubic, int halvings)
{
    const int room = halvings == 1 ? 3 : 1; // for second differences: 24 times the reach / 4^halvings
    const std::int32_t reach = std::numeric_limits<std::int32_t>::max() >> (3 * halvings + room);
    const auto is_near = [&cubic, reach](Point point) {
        const Point away = point - cubic.from;
        return std::abs(away.x.raw()) <= reach && std::abs(away.y.raw()) <= reach;
    };
    return is_near(cubic.c1) && is_near(cubic.c2) && is_near(cubic.to);
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

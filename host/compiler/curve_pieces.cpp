#include "host/compiler/curve_pieces.hpp"

#include "core/equalize.hpp"
#include "core/kfb_limits.hpp"
#include "host/compiler/model_reader.hpp"

#include <algorithm>
#include <cmath>

namespace kfast {
namespace {

constexpr double tolerance = 1.0 / 32;

/// The larger second difference of the control points of one coordinate, in pixels. A line has none.
double bend(const Segment& segment, Fixed Point::*axis)
{
    if (segment.kind == Segment::Kind::line)
        return 0;
    const auto second = [axis](Point a, Point b, Point c) {
        return std::abs(static_cast<double>((a.*axis).raw()) - 2.0 * (b.*axis).raw() + (c.*axis).raw());
    };
    return std::max(second(segment.from, segment.c1, segment.c2),
                    second(segment.c1, segment.c2, segment.to)) /
           Fixed::one;
}

/// On the way each coordinate is between its two ends, whatever the laws, and so is its bend.
double bend_between(const Pair<Segment>& both)
{
    return std::hypot(std::max(bend(both.a, &Point::x), bend(both.b, &Point::x)),
                      std::max(bend(both.a, &Point::y), bend(both.b, &Point::y)));
}

}

// A piece over 1/n of the parameter stays within the second derivative / (8 n^2) of the curve; the second
// derivative of a cubic is at most 6 times the bend of its control points.
std::uint32_t curve_pieces(const scene::Drawing& a, const scene::Drawing& b)
{
    double most = 0;
    EqualizedPair pair{ModelReader{a}, ModelReader{b}};
    while (const std::uint32_t segments = pair.next_stroke())
        for (std::uint32_t i = 0; i < segments; ++i)
            most = std::max(most, bend_between(pair.next_segment()));
    const double pieces = std::ceil(std::sqrt(6 * most / (8 * tolerance)));
    return std::clamp<std::uint32_t>(static_cast<std::uint32_t>(pieces), 1, kfb::max_curve_pieces);
}

}

#include "host/compiler/curve_pieces.hpp"

#include "core/equalize.hpp"
#include "core/kfb_limits.hpp"
#include "host/compiler/model_reader.hpp"

#include <algorithm>
#include <cmath>

namespace kfast {
namespace {

constexpr double tolerance = 1.0 / 32;

/// The second differences of the control points of one coordinate, in pixels. A line has none.
struct Bend {
    double first = 0;
    double second = 0;
};

Bend bend(const Segment& segment, Fixed Point::*axis)
{
    if (segment.kind == Segment::Kind::line)
        return {};
    const auto pixels = [axis](Point at) { return static_cast<double>((at.*axis).raw()) / Fixed::one; };
    const double c1 = pixels(segment.c1);
    const double c2 = pixels(segment.c2);
    return {pixels(segment.from) - 2 * c1 + c2, c1 - 2 * c2 + pixels(segment.to)};
}

/// The larger second difference at a share of the way.
double bend_at(Bend a, Bend b, Way way)
{
    const double share = static_cast<double>(way.raw) / Way::one;
    return std::max(std::abs(std::lerp(a.first, b.first, share)),
                    std::abs(std::lerp(a.second, b.second, share)));
}

/// Bends change evenly along the way, so that they are largest at one of its ends.
double most_bend(const Pair<Segment>& both, Fixed Point::*axis, WayRange range)
{
    const Bend a = bend(both.a, axis);
    const Bend b = bend(both.b, axis);
    return std::max(bend_at(a, b, range.least), bend_at(a, b, range.most));
}

// Not std::hypot, which platforms round differently.
double length(double x, double y) { return std::sqrt(x * x + y * y); }

}

std::uint32_t curve_pieces(const scene::Drawing& a, const scene::Drawing& b, WayRange x, WayRange y,
                           double scale)
{
    double most = 0;
    EqualizedPair pair{ModelReader{a}, ModelReader{b}};
    while (const std::uint32_t segments = pair.next_stroke())
        for (std::uint32_t i = 0; i < segments; ++i) {
            const Pair<Segment> both = pair.next_segment();
            most = std::max(most, length(most_bend(both, &Point::x, x), most_bend(both, &Point::y, y)));
        }
    return pieces_for_bend(most, scale);
}

double bend_of(const Segment& segment)
{
    const Bend x = bend(segment, &Point::x);
    const Bend y = bend(segment, &Point::y);
    return std::max(length(x.first, y.first), length(x.second, y.second));
}

// A piece over 1/n of the parameter stays within the second derivative / (8 n^2) of the curve; the second
// derivative of a cubic is at most 6 times the bend of its control points.
std::uint32_t pieces_for_bend(double bend, double scale)
{
    const double pieces = std::ceil(std::sqrt(6 * bend * scale / (8 * tolerance)));
    return static_cast<std::uint32_t>(std::clamp<double>(pieces, 1, kfb::max_curve_pieces));
}

}

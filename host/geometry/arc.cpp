#include "host/geometry/arc.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace kfast::scene {

namespace {

/// `spot` moved along the tangent of the unit circle, clockwise.
Vec2 moved(Vec2 spot, double along) { return spot + along * Vec2{-spot.y, spot.x}; }

}

Vec2 on_unit_circle(double degrees)
{
    int quarters = 0; // its last three bits, with the sign of `degrees`
    const double rest = std::remquo(degrees, 90.0, &quarters) * std::numbers::pi / 180;
    Vec2 spot{std::cos(rest), std::sin(rest)};
    for (int i = quarters & 3; i > 0; --i)
        spot = {-spot.y, spot.x};
    return spot;
}

int arc_pieces(double quarters)
{
    // A quarter that rounding made slightly too long is still one piece.
    return std::max(1, static_cast<int>(std::ceil(quarters - 1e-9)));
}

Curve unit_arc(Vec2 from, Vec2 to, double radians)
{
    const double handle = 4.0 / 3.0 * std::tan(radians / 4);
    return cubic_to(moved(from, handle), moved(to, -handle), to);
}

namespace {

/// Lengths outside of these count as 0 and as `longest`: on a canvas they make no difference, and within
/// them no square or quotient of the formulas leaves the range of double.
constexpr double shortest = 1e-9;
constexpr double longest = 1e9;

double usable_radius(double radius) { return std::min(std::abs(radius), longest); }

Vec2 turned(Vec2 spot, double cosine, double sine)
{
    return {cosine * spot.x - sine * spot.y, sine * spot.x + cosine * spot.y};
}

/// An arc in the terms of its ellipse (SVG 2, appendix B.2, gives the formulas and their names).
class Ellipse {
public:
    explicit Ellipse(const Arc& arc)
        : cosine_{std::cos(arc.rotation * std::numbers::pi / 180)},
          sine_{std::sin(arc.rotation * std::numbers::pi / 180)},
          radii_{usable_radius(arc.radius_x), usable_radius(arc.radius_y)}
    {
        const Vec2 half = turned(0.5 * (arc.from - arc.to), cosine_, -sine_);
        const double stretch = std::hypot(half.x / radii_.x, half.y / radii_.y);
        radii_ = std::max(1.0, stretch) * radii_;
        const Vec2 centre = centre_from_chord({half.x / radii_.x, half.y / radii_.y}, arc.large != arc.sweep);
        start_ = std::atan2(half.y / radii_.y - centre.y, half.x / radii_.x - centre.x);
        const double end = std::atan2(-half.y / radii_.y - centre.y, -half.x / radii_.x - centre.x);
        extent_ = signed_extent(end - start_, arc.sweep);
        centre_ =
            turned({centre.x * radii_.x, centre.y * radii_.y}, cosine_, sine_) + 0.5 * (arc.from + arc.to);
    }

    std::vector<Curve> curves() const
    {
        const int count = arc_pieces(std::abs(extent_) / (std::numbers::pi / 2));
        std::vector<Curve> curves;
        curves.reserve(static_cast<std::size_t>(count));
        for (int i = 0; i < count; ++i)
            curves.push_back(piece(start_ + extent_ * i / count, extent_ / count));
        return curves;
    }

private:
    /// The centre of the unit circle with the chord from `half` to -half.
    static Vec2 centre_from_chord(Vec2 half, bool clockwise_of_chord)
    {
        const double square = half.x * half.x + half.y * half.y;
        const double away = std::sqrt(std::max(0.0, 1 / square - 1));
        const Vec2 centre{away * half.y, -away * half.x};
        return clockwise_of_chord ? centre : -1.0 * centre;
    }

    static double signed_extent(double difference, bool sweep)
    {
        if (sweep && difference < 0)
            return difference + 2 * std::numbers::pi;
        if (!sweep && difference > 0)
            return difference - 2 * std::numbers::pi;
        return difference;
    }

    Curve piece(double angle, double extent) const
    {
        const double end = angle + extent;
        const Curve unit =
            unit_arc({std::cos(angle), std::sin(angle)}, {std::cos(end), std::sin(end)}, extent);
        return cubic_to(on_canvas(unit.c1), on_canvas(unit.c2), on_canvas(unit.to));
    }

    Vec2 on_canvas(Vec2 unit) const
    {
        return centre_ + turned({radii_.x * unit.x, radii_.y * unit.y}, cosine_, sine_);
    }

    double cosine_;
    double sine_;
    Vec2 radii_;
    Vec2 centre_;
    double start_ = 0;
    double extent_ = 0;
};

}

std::vector<Curve> curves_of(const Arc& arc)
{
    const Vec2 chord = arc.to - arc.from;
    if (std::min({std::abs(arc.radius_x), std::abs(arc.radius_y), std::hypot(chord.x, chord.y)}) < shortest)
        return {line_to(arc.to)};
    std::vector<Curve> curves = Ellipse{arc}.curves();
    curves.back().to = arc.to;
    return curves;
}

namespace {

Vec2 on_canvas(const Sector& sector, Vec2 unit)
{
    return sector.centre + Vec2{sector.radius_x * unit.x, sector.radius_y * unit.y};
}

Curve piece(const Sector& sector, double from, double to)
{
    const Curve unit =
        unit_arc(on_unit_circle(from), on_unit_circle(to), (to - from) * std::numbers::pi / 180);
    return cubic_to(on_canvas(sector, unit.c1), on_canvas(sector, unit.c2), on_canvas(sector, unit.to));
}

Vec2 begin(const Sector& sector) { return on_canvas(sector, on_unit_circle(sector.from)); }

void append_arc(Outline& outline, const Sector& sector)
{
    const double extent = sector.to - sector.from;
    const int count = arc_pieces(std::abs(extent) / 90);
    const auto angle = [&](int i) { return sector.from + extent * i / count; };
    for (int i = 0; i < count; ++i)
        outline.curves.push_back(piece(sector, angle(i), angle(i + 1)));
}

}

Outline arc(const Sector& sector)
{
    Outline outline{.from = begin(sector), .curves = {}, .closed = false, .sector = sector};
    append_arc(outline, sector);
    return outline;
}

Outline pie(const Sector& sector)
{
    Outline outline{
        .from = sector.centre, .curves = {line_to(begin(sector))}, .closed = true, .sector = sector};
    append_arc(outline, sector);
    return outline;
}

Outline ring_piece(const Sector& sector, double inner)
{
    const Sector back{sector.centre, inner, inner, sector.to, sector.from};
    Outline outline = arc(sector);
    outline.closed = true;
    outline.curves.push_back(line_to(begin(back)));
    append_arc(outline, back);
    return outline;
}

}

#include "host/synfig/layers/line_shape.hpp"

#include "host/art/animation/animated.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>

namespace kfast::synfig {
namespace {

using scene::Curve;
using scene::Outline;

// Curves for each piece, on each side.
constexpr int parts = 4;
// Synfig's corners reach no further than that many half widths.
constexpr double longest_corner = 2;

Vec2 unit(Vec2 spot)
{
    const double length = std::sqrt(scene::dot(spot, spot));
    return length < 1e-12 ? Vec2{} : 1 / length * spot;
}
Vec2 left_of(Vec2 direction) { return {direction.y, -direction.x}; }

/// Two curves along a circle, from one point on it to another, the shorter way round.
void add_arc(std::vector<Curve>& curves, Vec2 centre, Vec2 from, Vec2 to, double angle)
{
    constexpr int halves = 2;
    const double step = angle / halves;
    const double arm = 4.0 / 3 * std::tan(step / 4);
    const double cosine = std::cos(step);
    const double sine = std::sin(step);
    Vec2 radius = from - centre;
    for (int i = 0; i < halves; ++i) {
        const Vec2 next =
            i + 1 == halves ? to - centre
                            : Vec2{cosine * radius.x - sine * radius.y, sine * radius.x + cosine * radius.y};
        curves.push_back(scene::cubic_to(centre + radius + arm * Vec2{-radius.y, radius.x},
                                         centre + next - arm * Vec2{-next.y, next.x}, centre + next));
        radius = next;
    }
}

class LineShape {
public:
    explicit LineShape(const VaryingLine& line) : line_{line}
    {
        double total = 0;
        for (const SplinePiece& piece : line.pieces) {
            begins_.push_back(total);
            total += piece.length();
        }
        begins_.push_back(total);
    }

    art::Drawing drawing() const
    {
        if (line_.loop)
            return {{ring(1), reversed(ring(-1))}};
        Outline outline{side_spot(0, from(0), 1), {}, true};
        add_side(outline.curves, 1);
        const std::size_t last = line_.pieces.size() - 1;
        add_end(outline.curves, last, to(last), line_.end, 1);
        Outline back{side_spot(0, from(0), -1), {}, false};
        add_side(back.curves, -1);
        const Outline other = reversed(back);
        outline.curves.insert(outline.curves.end(), other.curves.begin(), other.curves.end());
        add_end(outline.curves, 0, from(0), line_.begin, -1);
        return {{std::move(outline)}};
    }

private:
    double length(std::size_t piece) const { return begins_[piece + 1] - begins_[piece]; }

    /// The fraction of a piece at that distance along the line, approximately: by length within it.
    double share_at(std::size_t piece, double distance) const
    {
        const double aim = distance - begins_[piece];
        if (aim <= 0 || length(piece) <= 0)
            return 0;
        if (aim >= length(piece))
            return 1;
        double low = 0;
        double high = 1;
        for (int step = 0; step < 24; ++step) {
            const double middle = (low + high) / 2;
            (line_.pieces[piece].length(middle) < aim ? low : high) = middle;
        }
        return (low + high) / 2;
    }
    double from(std::size_t piece) const { return line_.loop ? 0 : share_at(piece, line_.from); }
    double to(std::size_t piece) const { return line_.loop ? 1 : share_at(piece, line_.to); }

    Vec2 direction(std::size_t piece, double share) const
    {
        const SplinePiece& own = line_.pieces[piece];
        const Vec2 found = unit(own.direction(share));
        if (found.x != 0 || found.y != 0)
            return found;
        constexpr double near = 1e-3;
        return unit(own.at(std::min(1.0, share + near)) - own.at(std::max(0.0, share - near)));
    }

    double half_width(std::size_t piece, double share) const
    {
        return line_.half_width(begins_[piece] + line_.pieces[piece].length(share));
    }

    Vec2 side_spot(std::size_t piece, double share, double side) const
    {
        return line_.pieces[piece].at(share) +
               side * half_width(piece, share) * left_of(direction(piece, share));
    }

    Vec2 side_direction(std::size_t piece, double share, double side) const
    {
        constexpr double near = 1e-3;
        const double before = std::max(0.0, share - near);
        const double behind = std::min(1.0, share + near);
        return 1 / (behind - before) * (side_spot(piece, behind, side) - side_spot(piece, before, side));
    }

    void add_side(std::vector<Curve>& curves, double side) const
    {
        for (std::size_t piece = 0; piece < line_.pieces.size(); ++piece) {
            const double begin = from(piece);
            const double span = to(piece) - begin;
            for (int i = 0; i < parts; ++i)
                add_part(curves, piece, begin + span * i / parts, begin + span * (i + 1) / parts, side);
            if (piece + 1 < line_.pieces.size() || line_.loop)
                add_corner(curves, piece, side);
        }
    }

    void add_part(std::vector<Curve>& curves, std::size_t piece, double from, double to, double side) const
    {
        const Vec2 begin = side_spot(piece, from, side);
        const Vec2 end = side_spot(piece, to, side);
        const double third = (to - from) / 3;
        curves.push_back(scene::cubic_to(begin + third * side_direction(piece, from, side),
                                         end - third * side_direction(piece, to, side), end));
    }

    /// Two curves from the end of a piece to the beginning of the next one.
    void add_corner(std::vector<Curve>& curves, std::size_t piece, double side) const
    {
        const std::size_t next = (piece + 1) % line_.pieces.size();
        const Vec2 before = direction(piece, 1);
        const Vec2 behind = direction(next, 0);
        const Vec2 from = side_spot(piece, 1, side);
        const Vec2 to = side_spot(next, 0, side);
        const Vec2 corner = line_.pieces[piece].to;
        const double angle = std::atan2(scene::cross(before, behind), scene::dot(before, behind));
        const bool outer = angle * side > 0;
        if (outer && line_.corner == Corner::round) {
            add_arc(curves, corner, from, to, angle);
            return;
        }
        Vec2 tip = 0.5 * (from + to);
        if (outer && line_.corner == Corner::sharp && to_end(piece)) {
            const double width = half_width(piece, 1);
            const double reach = std::min(longest_corner, 1 / std::max(1e-6, std::cos(angle / 2)));
            tip = corner + side * reach * width * unit(left_of(before) + left_of(behind));
        }
        curves.push_back(as_cubic(from, tip));
        curves.push_back(as_cubic(tip, to));
    }
    /// Whether the line goes on after the piece.
    bool to_end(std::size_t piece) const { return line_.loop || line_.to > begins_[piece + 1]; }

    static Curve as_cubic(Vec2 from, Vec2 to)
    {
        return scene::cubic_to(from + 1.0 / 3 * (to - from), from + 2.0 / 3 * (to - from), to);
    }

    /// From one side to the other; `outward` is 1 at the end and -1 at the beginning.
    void add_end(std::vector<Curve>& curves, std::size_t piece, double share, Side kind, double outward) const
    {
        const Vec2 from = side_spot(piece, share, outward);
        const Vec2 to = side_spot(piece, share, -outward);
        const Vec2 middle = line_.pieces[piece].at(share);
        const Vec2 ahead = outward * half_width(piece, share) * direction(piece, share);
        switch (kind) {
        case Side::round:
            add_arc(curves, middle, from, to, std::numbers::pi);
            return;
        case Side::inner_round:
            add_arc(curves, middle, from, to, -std::numbers::pi);
            return;
        case Side::square:
            for (const Vec2 spot : {from + ahead, to + ahead, to})
                curves.push_back(scene::line_to(spot));
            return;
        case Side::peak:
            curves.push_back(scene::line_to(middle + ahead));
            break;
        case Side::inner_peak:
            curves.push_back(scene::line_to(middle - ahead));
            break;
        case Side::interpolate:
        case Side::flat:
            break;
        }
        curves.push_back(scene::line_to(to));
    }

    Outline ring(double side) const
    {
        Outline outline{side_spot(0, 0, side), {}, true};
        add_side(outline.curves, side);
        return outline;
    }

    static Outline reversed(const Outline& outline)
    {
        Outline result{outline.curves.back().to, {}, outline.closed};
        for (std::size_t i = outline.curves.size(); i-- > 0;) {
            const Curve& curve = outline.curves[i];
            result.curves.push_back(
                scene::cubic_to(curve.c2, curve.c1, i == 0 ? outline.from : outline.curves[i - 1].to));
        }
        return result;
    }

    const VaryingLine& line_;
    std::vector<double> begins_; ///< of the pieces, and the end of the last
};

/// The slope of a smooth curve through a stop: between those to its neighbours, and level at extremes.
double slope_at(const std::vector<WidthStop>& stops, std::size_t index)
{
    if (index == 0 || index + 1 == stops.size())
        return 0;
    const auto secant = [&](std::size_t i) {
        return (stops[i + 1].half_width - stops[i].half_width) /
               std::max(1e-9, stops[i + 1].distance - stops[i].distance);
    };
    const double before = secant(index - 1);
    const double behind = secant(index);
    if (before * behind <= 0)
        return 0;
    const double limit = 3 * std::min(std::abs(before), std::abs(behind));
    return std::clamp((before + behind) / 2, -limit, limit);
}

}

double VaryingLine::half_width(double distance) const
{
    const auto next = std::ranges::upper_bound(stops, distance, {}, &WidthStop::distance);
    if (next == stops.begin())
        return next->half_width;
    const WidthStop& before = *std::prev(next);
    if (next == stops.end())
        return before.half_width;
    const double span = next->distance - before.distance;
    const double share = (distance - before.distance) / span;
    const double dipped =
        next + 1 == stops.end() ? 3 * dip * share * share * (1 - share) * next->half_width : 0;
    const double straight = art::mixed(before.half_width, next->half_width, share) - dipped;
    if (smoothness <= 0)
        return straight;
    const std::size_t index = static_cast<std::size_t>(std::prev(next) - stops.begin());
    const double rest = 1 - share;
    const double smooth = rest * rest * (1 + 2 * share) * before.half_width +
                          share * share * (3 - 2 * share) * next->half_width +
                          span * (share * rest * rest * slope_at(stops, index) -
                                  share * share * rest * slope_at(stops, index + 1));
    return art::mixed(straight, smooth - dipped, std::min(1.0, smoothness));
}

art::Drawing shape_of(const VaryingLine& line) { return LineShape{line}.drawing(); }

}

#include "host/art/geometry/convex_polygon.hpp"

#include "host/art/geometry/curves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace kfast::art {
namespace {

using scene::Curve;
using scene::Outline;
using scene::Vec2;

/// Parameters at which a polynomial in Bernstein's form changes its sign: where its coefficients do not, it
/// does not either.
void find_crossings(const std::array<double, 4>& depths, double from, double to, std::vector<double>& found)
{
    constexpr double exact = 1e-9;
    const bool begins_inside = depths[0] > 0;
    if (std::ranges::all_of(depths, [&](double depth) { return (depth > 0) == begins_inside; }))
        return;
    const double middle = (from + to) / 2;
    if (to - from < exact) {
        if ((depths[3] > 0) != begins_inside)
            found.push_back(middle);
        return;
    }
    const auto mean = [](double a, double b) { return (a + b) / 2; };
    const double a = mean(depths[0], depths[1]);
    const double b = mean(depths[1], depths[2]);
    const double c = mean(depths[2], depths[3]);
    const double half = mean(mean(a, b), mean(b, c));
    find_crossings({depths[0], a, mean(a, b), half}, from, middle, found);
    find_crossings({half, mean(b, c), c, depths[3]}, middle, to, found);
}

double doubled_area(std::span<const Vec2> polygon)
{
    double area = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        area += cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
    return area;
}

std::vector<Vec2> corners_of(const Outline& outline)
{
    std::vector<Vec2> corners{outline.from};
    for (const Curve& curve : outline.curves)
        if (scene::distance(corners.back(), curve.to) > 0)
            corners.push_back(curve.to);
    if (corners.size() > 1 && scene::distance(corners.back(), corners.front()) == 0)
        corners.pop_back();
    return corners;
}

}

// On the line itself as well, so that what runs along it does not flicker.
double ConvexPolygon::Side::depth(Vec2 spot) const
{
    constexpr double breadth = 1e-3;
    return dot(inward, spot - on) + breadth;
}

/// An outline while it is cut at one line.
class ConvexPolygon::Cut {
public:
    explicit Cut(const Side& side) : side_{side} {}

    void add(Vec2 from, const Curve& curve)
    {
        const Curve cubic = as_cubic(from, curve);
        const CubicPiece whole{{from, cubic.c1, cubic.c2, cubic.to}};
        std::vector<double> ends = crossings(whole, curve.cubic);
        ends.push_back(1);
        double begin = 0;
        for (const double end : ends) {
            if (side_.depth(whole.at((begin + end) / 2)) > 0)
                keep(whole.between(begin, end), curve.cubic);
            begin = end;
        }
    }

    /// Nothing if nothing with an area is left.
    std::optional<Outline> finish()
    {
        kept_.closed = true;
        const bool is_line = kept_.curves.size() == 1 && !kept_.curves.front().cubic;
        return kept_.curves.empty() || is_line ? std::nullopt : std::optional{std::move(kept_)};
    }

private:
    std::vector<double> crossings(const CubicPiece& whole, bool is_curve) const
    {
        std::array<double, 4> depths{};
        std::ranges::transform(whole.points, depths.begin(), [&](Vec2 spot) { return side_.depth(spot); });
        std::vector<double> found;
        if (is_curve)
            find_crossings(depths, 0, 1, found);
        else if ((depths[0] > 0) != (depths[3] > 0))
            found.push_back(depths[0] / (depths[0] - depths[3]));
        return found;
    }

    void keep(const CubicPiece& piece, bool is_curve)
    {
        constexpr double nowhere = 1e-9;
        if (kept_.curves.empty())
            kept_.from = piece.points[0];
        else if (scene::distance(kept_.curves.back().to, piece.points[0]) > nowhere)
            kept_.curves.push_back(scene::line_to(piece.points[0]));
        kept_.curves.push_back(is_curve ? scene::cubic_to(piece.points[1], piece.points[2], piece.points[3])
                                        : scene::line_to(piece.points[3]));
    }

    const Side& side_;
    Outline kept_;
};

std::optional<Outline> ConvexPolygon::cut(const Outline& outline, const Side& side)
{
    Cut cut{side};
    Vec2 from = outline.from;
    for (const Curve& curve : outline.curves) {
        cut.add(from, curve);
        from = curve.to;
    }
    if (scene::distance(from, outline.from) > 0)
        cut.add(from, scene::line_to(outline.from));
    return cut.finish();
}

ConvexPolygon::ConvexPolygon(std::vector<Vec2> corners) : corners_{std::move(corners)}
{
    const double turn = doubled_area(corners_) < 0 ? -1 : 1;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        const Vec2 way = corners_[(i + 1) % corners_.size()] - corners_[i];
        sides_.push_back({corners_[i], turn / std::sqrt(dot(way, way)) * Vec2{-way.y, way.x}});
    }
}

std::optional<ConvexPolygon> ConvexPolygon::of(const Drawing& drawing)
{
    if (drawing.outlines.size() != 1 || std::ranges::any_of(drawing.outlines.front().curves, &Curve::cubic))
        return std::nullopt;
    std::vector<Vec2> corners = corners_of(drawing.outlines.front());
    if (corners.size() < 3 || doubled_area(corners) == 0)
        return std::nullopt;
    ConvexPolygon polygon{std::move(corners)};
    // The corners of a star are not all on one side of its sides.
    return polygon.contains(polygon.corners_, 0) ? std::optional{std::move(polygon)} : std::nullopt;
}

bool ConvexPolygon::contains(std::span<const Vec2> points, double distance) const
{
    return std::ranges::all_of(sides_, [&](const Side& side) {
        return std::ranges::all_of(points, [&](Vec2 point) { return side.depth(point) >= distance; });
    });
}

bool ConvexPolygon::misses(std::span<const Vec2> points, double distance) const
{
    return std::ranges::any_of(sides_, [&](const Side& side) {
        return std::ranges::all_of(points, [&](Vec2 point) { return side.depth(point) <= -distance; });
    });
}

Drawing ConvexPolygon::cut(const Drawing& drawing) const
{
    Drawing result;
    for (const Outline& outline : drawing.outlines) {
        std::optional<Outline> rest = outline;
        for (const Side& side : sides_)
            if (rest)
                rest = cut(*rest, side);
        if (rest)
            result.outlines.push_back(std::move(*rest));
    }
    return result;
}

}

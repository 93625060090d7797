#include "host/svg/parts/clipped_part.hpp"

#include "host/art/geometry/curves.hpp"
#include "host/svg/parts/motion.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace kfast::svg {

namespace {

using scene::Vec2;

/// Curves as 16 lines each.
std::vector<Vec2> corners_of(const scene::Outline& outline)
{
    constexpr int steps = 16;
    std::vector<Vec2> corners{outline.from};
    for (const scene::Curve& curve : outline.curves) {
        const Vec2 from = corners.back();
        for (int step = curve.cubic ? 1 : steps; step <= steps; ++step)
            corners.push_back(art::spot_on(from, curve, static_cast<double>(step) / steps));
    }
    return corners;
}

/// On which sides of the area's edges a point is: on both, if it is outside.
struct Sides {
    bool left = false;
    bool right = false;
};

Sides sides_of(Vec2 place, const std::vector<Vec2>& corners)
{
    constexpr double tolerance = 0.01;
    Sides sides;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 from = corners[i];
        const Vec2 to = corners[(i + 1) % corners.size()];
        const double length = scene::distance(from, to);
        const double beside = length > 0 ? scene::cross(to - from, place - from) / length : 0;
        sides.left = sides.left || beside < -tolerance;
        sides.right = sides.right || beside > tolerance;
    }
    return sides;
}

bool lie_inside(std::span<const Vec2> places, const std::vector<Vec2>& corners)
{
    return std::ranges::all_of(places, [&](Vec2 place) {
        const Sides sides = sides_of(place, corners);
        return sides.left != sides.right;
    });
}

}

std::optional<std::vector<Vec2>> convex_corners(const art::Drawing& drawing)
{
    if (drawing.outlines.size() != 1 || drawing.outlines.front().curves.size() < 2)
        return std::nullopt;
    auto corners = corners_of(drawing.outlines.front());
    if (scene::distance(corners.front(), corners.back()) <= 0)
        corners.pop_back();
    constexpr std::size_t max = 1024; // they are compared with each other
    return corners.size() <= max && lie_inside(corners, corners) ? std::optional{corners} : std::nullopt;
}

bool covers(const art::Drawing& area, std::span<const Vec2> places)
{
    const auto corners = convex_corners(area);
    return corners && lie_inside(places, *corners);
}

namespace {

using scene::Curve;
using scene::Outline;

/// One edge of an area, from its inside.
struct Edge {
    Vec2 on;
    Vec2 inwards;

    /// Positive inside.
    double depth(Vec2 spot) const { return scene::dot(spot - on, inwards); }
};

struct Segment {
    art::CubicPiece piece; ///< of lines, only the ends count
    bool cubic = false;

    Vec2 from() const { return piece.points[0]; }
    Vec2 to() const { return piece.points[3]; }
    Vec2 at(double t) const { return cubic ? piece.at(t) : from() + t * (to() - from()); }

    Segment between(double begin, double end) const
    {
        if (cubic)
            return {piece.between(begin, end), true};
        return {{{at(begin), {}, {}, at(end)}}, false};
    }
    Curve curve() const
    {
        return cubic ? scene::cubic_to(piece.points[1], piece.points[2], to()) : scene::line_to(to());
    }
};

/// With the line that closes the outline.
std::vector<Segment> segments_of(const Outline& outline)
{
    std::vector<Segment> segments;
    Vec2 from = outline.from;
    for (const Curve& curve : outline.curves) {
        segments.push_back({{{from, curve.c1, curve.c2, curve.to}}, curve.cubic});
        from = curve.to;
    }
    if (scene::distance(from, outline.from) > 0)
        segments.push_back({{{from, {}, {}, outline.from}}, false});
    return segments;
}

/// Where the sign of the depth changes between two parameters.
double crossing(const Segment& segment, const Edge& edge, double begin, double end)
{
    const bool begins_inside = edge.depth(segment.at(begin)) >= 0;
    constexpr int halvings = 48;
    for (int i = 0; i < halvings; ++i) {
        const double middle = (begin + end) / 2;
        (begins_inside == (edge.depth(segment.at(middle)) >= 0) ? begin : end) = middle;
    }
    return (begin + end) / 2;
}

/// Parameters where a segment crosses an edge, with 0 and 1 around them. A cubic is sampled at 16 points, so
/// that what is beyond an edge between two of these stays there.
std::vector<double> cuts_of(const Segment& segment, const Edge& edge)
{
    constexpr double at_its_end = 1e-7; // where rounding turns a touch into a crossing
    const int steps = segment.cubic ? 16 : 1;
    std::vector<double> cuts{0};
    for (int step = 0; step < steps; ++step) {
        const double begin = static_cast<double>(step) / steps;
        const double end = static_cast<double>(step + 1) / steps;
        if ((edge.depth(segment.at(begin)) >= 0) == (edge.depth(segment.at(end)) >= 0))
            continue;
        const double cut = crossing(segment, edge, begin, end);
        if (cut > at_its_end && cut < 1 - at_its_end)
            cuts.push_back(cut);
    }
    cuts.push_back(1);
    return cuts;
}

class InsideOutline {
public:
    void add(const Segment& segment)
    {
        if (!outline_)
            outline_ = Outline{segment.from(), {}, true};
        else if (scene::distance(last(), segment.from()) > 1e-9)
            outline_->curves.push_back(scene::line_to(segment.from()));
        outline_->curves.push_back(segment.curve());
    }

    std::optional<Outline> taken() { return std::move(outline_); }

private:
    Vec2 last() const { return outline_->curves.back().to; }

    std::optional<Outline> outline_;
};

/// Sutherland-Hodgman clipping, an edge at a time; inside, the winding number of every point is
/// preserved.
std::optional<Outline> cut_at(const Edge& edge, const Outline& outline)
{
    constexpr double on_the_edge = 1e-9;
    InsideOutline inside;
    for (const Segment& segment : segments_of(outline)) {
        const auto cuts = cuts_of(segment, edge);
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
            if (edge.depth(segment.at((cuts[i] + cuts[i + 1]) / 2)) >= -on_the_edge)
                inside.add(cuts.size() == 2 ? segment : segment.between(cuts[i], cuts[i + 1]));
    }
    return inside.taken();
}

std::vector<Edge> edges_of(std::span<const Vec2> area)
{
    Vec2 middle;
    for (const Vec2 corner : area)
        middle = middle + (1 / static_cast<double>(area.size())) * corner;
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < area.size(); ++i) {
        const Vec2 along = area[(i + 1) % area.size()] - area[i];
        const double length = scene::distance({}, along);
        if (length <= 0)
            continue;
        const Vec2 normal = (1 / length) * Vec2{-along.y, along.x};
        edges.push_back({area[i], scene::dot(middle - area[i], normal) < 0 ? -1 * normal : normal});
    }
    return edges;
}

}

art::Drawing cut(const art::Drawing& drawing, std::span<const Vec2> area)
{
    art::Drawing result;
    const auto edges = edges_of(area);
    for (const Outline& outline : drawing.outlines) {
        std::optional<Outline> rest = outline;
        for (auto edge = edges.begin(); rest && edge != edges.end(); ++edge)
            rest = cut_at(*edge, *rest);
        if (rest && rest->curves.size() > 1)
            result.outlines.push_back(std::move(*rest));
    }
    return result;
}

namespace {

using art::Affine;

bool has_curves(const art::Drawing& drawing)
{
    return std::ranges::any_of(drawing.outlines, [](const scene::Outline& outline) {
        return std::ranges::any_of(outline.curves, &scene::Curve::cubic);
    });
}

std::size_t curves_in(const art::Drawing& drawing)
{
    std::size_t count = 0;
    for (const scene::Outline& outline : drawing.outlines)
        count += 1 + outline.curves.size();
    return count;
}

/// The intersection of both. If one of them has to consist of lines, it is the one that already does.
art::Drawing common(const art::Drawing& drawing, const art::Drawing& area, art::Budget& budget)
{
    const auto straight = has_curves(drawing) ? std::nullopt : convex_corners(drawing);
    const auto& cut_one = straight ? area : drawing;
    const auto corners = straight ? straight : convex_corners(area);
    if (!corners)
        return drawing;
    budget.take_computed_points(16 * curves_in(cut_one) * corners->size());
    return cut(cut_one, *corners);
}

}

bool Clip::apply(Part& part, const Affine& affine)
{
    const auto box = box_with_lines(part, affine);
    if (!box || covers(area_, corners_of(*box)))
        return true;
    if (cut(outline_of(*box), *convex_corners(area_)).outlines.empty())
        return false;
    if (part.fill && part.pen) {
        budget_.take_node();
        split_line(part, part.drawing, false);
    }
    if (part.is_group) {
        std::erase_if(part.parts, [&](Part& inner) { return !apply(inner, affine * inner.own); });
        return !part.parts.empty();
    }
    if (part.fill)
        return cut_fill(part, affine);
    whole_lines_.push_back(part.layer);
    return true;
}

bool Clip::cut_fill(Part& part, const Affine& affine)
{
    const auto inwards = affine.inverse();
    if (!inwards)
        return true; // it has no area
    part.drawing = common(part.drawing, seen_through(*inwards, area_), budget_);
    budget_.take_points(curves_in(part.drawing));
    return !part.drawing.outlines.empty();
}

}

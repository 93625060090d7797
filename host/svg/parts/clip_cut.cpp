#include "host/svg/parts/clip_cut.hpp"

#include "host/art/geometry/cubic_piece.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace kfast::svg {
namespace {

using scene::Curve;
using scene::Outline;
using scene::Vec2;

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

/// Parameters where a segment crosses an edge, with 0 and 1 around them. Of a cubic it is asked at 16 places,
/// so that what lies beyond an edge between two of these stays there.
std::vector<double> cuts_of(const Segment& segment, const Edge& edge)
{
    constexpr double at_its_end = 1e-7; // where rounding makes a crossing of a touch
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

/// As Sutherland and Hodgman cut polygons, an edge at a time; inside, every place is still wound about as
/// often.
std::optional<Outline> cut(const Outline& outline, const Edge& edge)
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
            rest = cut(*rest, *edge);
        if (rest && rest->curves.size() > 1)
            result.outlines.push_back(std::move(*rest));
    }
    return result;
}

}

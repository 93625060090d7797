#include "host/lottie/drawings/modifiers.hpp"

#include "host/lottie/drawings/dashes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace kfast::lottie {

namespace {

using art::Drawing;
using art::Trim;

/// The part of a length of 1; the end may be up to 2, past the beginning of another round.
Stretch stretch_at(const Trim& trim, double time)
{
    const double turn = trim.offset.at(time);
    const double offset = turn - std::floor(turn);
    // Eases may swing beyond.
    const double start = std::clamp(trim.start.at(time), 0.0, 1.0);
    const double end = std::clamp(trim.end.at(time), 0.0, 1.0);
    return {std::min(start, end) + offset, std::max(start, end) + offset};
}

struct Measured {
    std::vector<MeasuredOutline> outlines;
    double length = 0;
};

Measured measured(const Drawing& drawing)
{
    Measured result;
    for (const scene::Outline& outline : drawing.outlines) {
        result.outlines.emplace_back(outline);
        result.length += result.outlines.back().length();
    }
    return result;
}

void add_pieces(const std::vector<MeasuredOutline>& outlines, double begin, Stretch stretch, Drawing& drawing)
{
    for (const MeasuredOutline& outline : outlines) {
        scene::Outline piece = outline.piece({stretch.from - begin, stretch.to - begin});
        if (!piece.curves.empty())
            drawing.outlines.push_back(std::move(piece));
        begin += outline.length();
    }
}

/// The part of a closed outline through the point where it begins and ends.
Drawing around(const MeasuredOutline& outline, Stretch stretch)
{
    scene::Outline piece = outline.piece({stretch.from, outline.length()});
    append(piece, outline.piece({0, stretch.to - outline.length()}));
    if (piece.curves.empty())
        return {};
    return {{std::move(piece)}};
}

/// `begin` is where the drawing begins within the length of all that are trimmed.
Drawing trimmed(const Drawing& drawing, double begin, std::optional<double> length_of_all, Stretch share)
{
    constexpr double nearly_nothing = 1e-6;
    if (share.to - share.from < nearly_nothing)
        return {};
    if (share.to - share.from > 1 - nearly_nothing)
        return drawing;
    const Measured own = measured(drawing);
    const double all = length_of_all.value_or(own.length);
    if (share.from >= 1)
        share = {share.from - 1, share.to - 1};
    const Stretch stretch{share.from * all, share.to * all};
    const bool wraps = share.to > 1;
    if (wraps && !length_of_all && own.outlines.size() == 1 && own.outlines.front().is_closed())
        return around(own.outlines.front(), stretch);
    Drawing result;
    add_pieces(own.outlines, begin, {stretch.from, std::min(stretch.to, all)}, result);
    if (wraps)
        add_pieces(own.outlines, begin, {0, stretch.to - all}, result);
    return result;
}

/// How long each of several drawings is; those that never change are measured once.
class Lengths {
public:
    explicit Lengths(const std::vector<MovingDrawing*>& drawings)
    {
        for (const MovingDrawing* drawing : drawings)
            if (drawing->moments.empty())
                parts_.push_back({{}, measured(drawing->at(0)).length});
            else
                parts_.push_back({drawing->at, 0});
    }

    /// The sum of the first `count`.
    double sum(std::size_t count, double time) const
    {
        double sum = 0;
        for (std::size_t i = 0; i < count; ++i)
            sum += parts_[i].moving ? measured(parts_[i].moving(time)).length : parts_[i].length;
        return sum;
    }
    double sum(double time) const { return sum(parts_.size(), time); }

private:
    struct Part {
        std::function<Drawing(double)> moving; ///< none: always of that length
        double length = 0;
    };
    std::vector<Part> parts_;
};

/// A stretch that wraps makes two pieces of each outline, of which one curve is cut.
constexpr double max_growth = 2;

Moments moments_of(const Trim& trim)
{
    Moments moments;
    moments.add(trim.start);
    moments.add(trim.end);
    moments.add(trim.offset);
    return moments;
}

void trim_each(const Trim& trim, const std::vector<MovingDrawing*>& drawings)
{
    for (MovingDrawing* drawing : drawings) {
        drawing->moments.add(moments_of(trim));
        drawing->changes_form = drawing->changes_form || !drawing->moments.empty();
        drawing->cost += drawing->points * measuring_cost;
        drawing->points *= max_growth;
        drawing->at = [trim, at = drawing->at](double time) {
            return trimmed(at(time), 0, std::nullopt, stretch_at(trim, time));
        };
    }
}

void trim_as_one(const Trim& trim, const std::vector<MovingDrawing*>& drawings)
{
    Moments moments = moments_of(trim);
    double cost = 1;
    for (const MovingDrawing* drawing : drawings) {
        moments.add(drawing->moments);
        cost += drawing->moments.empty() ? 1 : 2 * (drawing->cost + drawing->points * measuring_cost);
    }
    const auto lengths = std::make_shared<const Lengths>(drawings);
    for (std::size_t i = 0; i < drawings.size(); ++i) {
        MovingDrawing& drawing = *drawings[i];
        drawing.moments = moments;
        drawing.changes_form = drawing.changes_form || !moments.empty();
        drawing.cost += drawing.points * measuring_cost + cost;
        drawing.points *= max_growth;
        drawing.at = [trim, lengths, i, at = drawing.at](double time) {
            return trimmed(at(time), lengths->sum(i, time), lengths->sum(time), stretch_at(trim, time));
        };
    }
}

}

void trim(const art::Trim& trim, const std::vector<MovingDrawing*>& drawings)
{
    if (trim.together && drawings.size() > 1)
        trim_as_one(trim, drawings);
    else
        trim_each(trim, drawings);
}

namespace {

using scene::Outline;
using scene::Vec2;

/// Where curves meet, with the control points on both sides.
struct Vertex {
    Vec2 in;
    Vec2 at;
    Vec2 out;
};

bool is_same(Vec2 left, Vec2 right) { return left.x == right.x && left.y == right.y; }

bool is_corner(const Vertex& vertex)
{
    return is_same(vertex.in, vertex.at) && is_same(vertex.out, vertex.at);
}

std::vector<Vertex> vertices_of(const Outline& outline)
{
    std::vector<Vertex> vertices{{outline.from, outline.from, outline.from}};
    for (const scene::Curve& curve : outline.curves) {
        if (curve.cubic)
            vertices.back().out = curve.c1;
        vertices.push_back({curve.cubic ? curve.c2 : curve.to, curve.to, curve.to});
    }
    if (outline.closed && vertices.size() > 1 && is_same(vertices.back().at, outline.from)) {
        vertices.front().in = vertices.back().in;
        vertices.pop_back();
    }
    return vertices;
}

scene::Curve curve_between(const Vertex& from, const Vertex& to)
{
    if (is_same(from.out, from.at) && is_same(to.in, to.at))
        return scene::line_to(to.at);
    return scene::cubic_to(from.out, to.in, to.at);
}

Outline outline_of(const std::vector<Vertex>& vertices, bool closed)
{
    Outline outline{vertices.front().at, {}, closed};
    for (std::size_t i = 1; i < vertices.size(); ++i)
        outline.curves.push_back(curve_between(vertices[i - 1], vertices[i]));
    if (closed)
        outline.curves.push_back(curve_between(vertices.back(), vertices.front()));
    return outline;
}

/// A vertex from the corner along a side; the control point is where a cubic comes nearest to an arc.
Vertex towards(Vec2 corner, Vec2 neighbour, double radius, bool arc_follows)
{
    constexpr double handle = 0.552284749830793398;
    const double side = scene::distance(corner, neighbour);
    const double reach = std::min(radius, side / 2);
    const Vec2 at = side > 0 ? corner + reach / side * (neighbour - corner) : corner;
    const Vec2 control = at + handle * (corner - at);
    return arc_follows ? Vertex{at, at, control} : Vertex{control, at, at};
}

Outline rounded(const Outline& outline, double radius)
{
    const auto vertices = vertices_of(outline);
    const std::size_t count = vertices.size();
    std::vector<Vertex> result;
    for (std::size_t i = 0; i < count; ++i) {
        const bool is_end = !outline.closed && (i == 0 || i == count - 1);
        if (is_end || !is_corner(vertices[i]) || count < 2) {
            result.push_back(vertices[i]);
            continue;
        }
        result.push_back(towards(vertices[i].at, vertices[(i + count - 1) % count].at, radius, true));
        result.push_back(towards(vertices[i].at, vertices[(i + 1) % count].at, radius, false));
    }
    return outline_of(result, outline.closed);
}

}

MovingDrawing with_rounded_corners(MovingDrawing drawing, const art::Channel& radius)
{
    if (radius.is_still() && radius.value() <= 0)
        return drawing;
    drawing.changes_form = drawing.changes_form || !drawing.moments.empty();
    drawing.moments.add(radius);
    drawing.points *= 2;
    drawing.cost += drawing.points;
    drawing.at = [radius, at = std::move(drawing.at)](double time) {
        art::Drawing result = at(time);
        for (Outline& outline : result.outlines)
            outline = rounded(outline, std::max(0.0, radius.at(time)));
        return result;
    };
    return drawing;
}

}

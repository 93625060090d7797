#include "host/lottie/drawings/extent.hpp"

#include "host/art/document/document.hpp"

#include <cmath>

namespace kfast::lottie {

namespace {

using art::Affine;
using scene::Vec2;

constexpr double breadth = 0.01;

bool is_shown(const art::Node& node, double time)
{
    return std::ranges::any_of(node.shown,
                               [&](const art::Span& span) { return span.from <= time && time < span.to; });
}

double scale_factor(const Affine& matrix) { return std::sqrt(std::abs(matrix.determinant())); }

void include(Box& box, const art::Shape& shape, double time, const Affine& matrix)
{
    Box drawn;
    for (const scene::Outline& outline : shape.drawing.at(time).outlines) {
        drawn.include(matrix.of(outline.from));
        for (const scene::Curve& curve : outline.curves) {
            if (curve.cubic) {
                drawn.include(matrix.of(curve.c1));
                drawn.include(matrix.of(curve.c2));
            }
            drawn.include(matrix.of(curve.to));
        }
    }
    if (!(drawn.left <= drawn.right))
        return;
    const double half = shape.stroke ? shape.stroke->width.at(time) * scale_factor(matrix) / 2 : 0;
    box.include({drawn.left - half, drawn.top - half});
    box.include({drawn.right + half, drawn.bottom + half});
}

void include(Box& box, const art::Use& use, const Affine& matrix, std::span<const Box> of_symbols)
{
    if (!(of_symbols[use.symbol].left <= of_symbols[use.symbol].right))
        return;
    for (int number = 0; number < use.copies.count; ++number)
        for (const Vec2 corner : of_symbols[use.symbol].corners())
            box.include((matrix * matrix_of(use.copies, number)).of(corner));
}

std::vector<Vec2> flattened(const scene::Outline& outline)
{
    constexpr int chords = 16;
    std::vector<Vec2> spots{outline.from};
    for (const scene::Curve& curve : outline.curves) {
        const Vec2 from = spots.back();
        for (int i = 1; i <= (curve.cubic ? chords : 1); ++i) {
            const double t = curve.cubic ? static_cast<double>(i) / chords : 1;
            const double rest = 1 - t;
            spots.push_back(curve.cubic ? rest * rest * rest * from + 3 * rest * rest * t * curve.c1 +
                                              3 * rest * t * t * curve.c2 + t * t * t * curve.to
                                        : curve.to);
        }
    }
    return spots;
}

bool is_inside(std::span<const Vec2> polygon, Vec2 spot)
{
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 a = polygon[i];
        const Vec2 b = polygon[(i + 1) % polygon.size()];
        if ((a.y > spot.y) != (b.y > spot.y) && spot.x < a.x + (spot.y - a.y) / (b.y - a.y) * (b.x - a.x))
            inside = !inside;
    }
    return inside;
}

bool cross_each_other(Vec2 a, Vec2 b, Vec2 c, Vec2 d)
{
    const auto side = [](Vec2 from, Vec2 to, Vec2 spot) { return cross(to - from, spot - from) > 0; };
    return side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b);
}

bool meet(std::span<const Vec2> one, std::span<const Vec2> other)
{
    for (std::size_t i = 0; i < one.size(); ++i)
        for (std::size_t k = 0; k < other.size(); ++k)
            if (cross_each_other(one[i], one[(i + 1) % one.size()], other[k], other[(k + 1) % other.size()]))
                return true;
    return false;
}

/// Corners are moved towards the middle, so that equal outlines do not touch.
std::vector<Vec2> shrunk(std::span<const Vec2> polygon)
{
    Vec2 middle;
    for (const Vec2 corner : polygon)
        middle = middle + 1.0 / static_cast<double>(polygon.size()) * corner;
    std::vector<Vec2> result;
    for (const Vec2 corner : polygon) {
        const double away = distance(middle, corner);
        result.push_back(away > breadth ? corner + breadth / away * (middle - corner) : middle);
    }
    return result;
}

}

void Box::include(Vec2 spot)
{
    left = std::min(left, spot.x);
    top = std::min(top, spot.y);
    right = std::max(right, spot.x);
    bottom = std::max(bottom, spot.y);
}

void Box::unite(const Box& other)
{
    if (!(other.left <= other.right))
        return;
    include({other.left, other.top});
    include({other.right, other.bottom});
}

bool Box::lies_within(const Box& other) const
{
    return empty() || (left >= other.left - breadth && top >= other.top - breadth &&
                       right <= other.right + breadth && bottom <= other.bottom + breadth);
}

bool Box::touches(const Box& other) const
{
    return !empty() && !other.empty() && left < other.right && other.left < right && top < other.bottom &&
           other.top < bottom;
}

std::vector<Vec2> Box::corners() const
{
    return {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

Box box_at(std::span<const art::Node> nodes, double time, const Affine& matrix,
           std::span<const Box> of_symbols)
{
    Box box;
    for (const art::Node& node : nodes) {
        if (!is_shown(node, time))
            continue;
        const Affine inner = matrix * matrix_at(node.transform, time);
        if (const auto* group = std::get_if<art::Group>(&node.content))
            box.unite(box_at(group->nodes, time, inner, of_symbols));
        else if (const auto* use = std::get_if<art::Use>(&node.content))
            include(box, *use, inner, of_symbols);
        else
            include(box, std::get<art::Shape>(node.content), time, inner);
    }
    return box;
}

Box box_in(std::span<const art::Node> nodes, const art::Span& span, std::span<const Box> of_symbols,
           art::Budget& budget)
{
    Box box;
    for (const double time : sample_times(span, weight(nodes), budget))
        box.unite(box_at(nodes, time, {}, of_symbols));
    return box;
}

bool contains(const art::Drawing& drawing, std::span<const Vec2> polygon)
{
    if (drawing.outlines.size() != 1)
        return false;
    const std::vector<Vec2> outline = flattened(drawing.outlines.front());
    const std::vector<Vec2> inner = shrunk(polygon);
    return std::ranges::all_of(inner, [&](Vec2 corner) { return is_inside(outline, corner); }) &&
           !meet(outline, inner);
}

std::size_t weight(const art::Transform& transform)
{
    // The point on a path is found by measuring it again and again.
    constexpr std::size_t measurements = 64;
    return transform.path ? 1 + measurements * transform.path->path.outlines.front().curves.size() : 1;
}

std::size_t weight(std::span<const art::Node> nodes)
{
    std::size_t total = 0;
    for (const art::Node& node : nodes) {
        total += weight(node.transform);
        if (const auto* group = std::get_if<art::Group>(&node.content))
            total += weight(group->nodes);
        else if (const auto* use = std::get_if<art::Use>(&node.content))
            total += static_cast<std::size_t>(use->copies.count);
        else
            for (const scene::Outline& outline :
                 std::get<art::Shape>(node.content).drawing.keys.front().value.outlines)
                total += outline.curves.size();
    }
    return total;
}

std::vector<double> sample_times(const art::Span& span, std::size_t weight, art::Budget& budget)
{
    constexpr double max_evaluated = 1e6;
    constexpr double max_samples = 120;
    const double length = span.to - span.from;
    const double affordable = std::clamp(max_evaluated / static_cast<double>(weight + 1), 2.0, max_samples);
    const double count = std::max(1.0, std::min(std::ceil(length), affordable));
    budget.take_computed_points(weight * static_cast<std::size_t>(count + 1));
    std::vector<double> times;
    for (double i = 0; i < count; ++i)
        times.push_back(span.from + i * length / count);
    times.push_back(span.to - std::min(0.001, length / 2));
    return times;
}

namespace {

Box box_around(std::span<const Vec2> spots)
{
    Box box;
    for (const Vec2 spot : spots)
        box.include(spot);
    return box;
}

Box box_around(const art::Drawing& drawing)
{
    Box box;
    for (const scene::Outline& outline : drawing.outlines) {
        box.include(outline.from);
        for (const scene::Curve& curve : outline.curves) {
            box.include(curve.to);
            if (curve.cubic) {
                box.include(curve.c1);
                box.include(curve.c2);
            }
        }
    }
    return box;
}

/// Its luminance, by sRGB's own weights; 1 if not `by_luminance`.
double strength(const art::Rgb& colour, bool by_luminance)
{
    return by_luminance ? 0.2126 * colour.red + 0.7152 * colour.green + 0.0722 * colour.blue : 1;
}

bool is_seen(const art::Node& node, double time)
{
    return std::ranges::any_of(node.shown,
                               [&](const art::Span& span) { return span.from <= time && time < span.to; });
}

Coverage coverage_by(const art::Node& node, std::span<const Vec2> polygon, const Affine& matrix, double time,
                     bool by_luminance)
{
    constexpr double nearly_all = 0.999;
    const double opacity = node.opacity.at(time);
    if (!is_seen(node, time) || opacity <= 0)
        return Coverage::nothing;
    const Affine inner = matrix * matrix_at(node.transform, time);
    Coverage coverage = Coverage::part;
    if (const auto* group = std::get_if<art::Group>(&node.content)) {
        coverage = coverage_of(polygon, group->nodes, inner, time, by_luminance);
    } else {
        const auto& shape = std::get<art::Shape>(node.content);
        const double fill =
            shape.fill ? shape.fill->opacity.at(time) * strength(shape.fill->colour.at(time), by_luminance)
                       : 0;
        const bool is_unpainted = fill <= 1 - nearly_all && !shape.stroke;
        if (is_unpainted || !box_at({&node, 1}, time, matrix).touches(box_around(polygon)))
            coverage = Coverage::nothing;
        else if (fill >= nearly_all && shape.drawing.at(time).outlines.size() == 1 &&
                 contains({{inner.of(shape.drawing.at(time).outlines.front())}}, polygon))
            coverage = Coverage::all;
    }
    return coverage == Coverage::all && opacity < nearly_all ? Coverage::part : coverage;
}

}

Coverage inverted(Coverage coverage)
{
    if (coverage == Coverage::part)
        return coverage;
    return coverage == Coverage::all ? Coverage::nothing : Coverage::all;
}

Coverage coverage_of(const Box& box, const art::Drawing& drawing)
{
    if (box.empty() || !box_around(drawing).touches(box))
        return Coverage::nothing;
    return contains(drawing, box.corners()) ? Coverage::all : Coverage::part;
}

Coverage coverage_of(std::span<const Vec2> polygon, std::span<const art::Node> nodes, const Affine& matrix,
                     double time, bool by_luminance)
{
    // Something dark may be above something bright.
    if (by_luminance && nodes.size() > 1)
        return Coverage::part;
    Coverage result = Coverage::nothing;
    for (const art::Node& node : nodes) {
        const Coverage by_node = coverage_by(node, polygon, matrix, time, by_luminance);
        if (by_node != Coverage::nothing && result != Coverage::all)
            result = by_node;
    }
    return result;
}

}

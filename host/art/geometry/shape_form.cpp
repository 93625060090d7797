#include "host/art/geometry/shape_form.hpp"

#include "host/geometry/shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace kfast::art {
namespace {

using scene::Outline;
using scene::Stroke;
using scene::Vec2;

/// Powers of ten up to the fifth, and 32: midpoints of two coordinates are multiples of 1/32.
constexpr std::array<double, 7> finenesses = {1, 10, 32, 100, 1'000, 10'000, 100'000};

double rounded(double value, double fineness) { return std::round(value * fineness) / fineness; }
Vec2 rounded(Vec2 spot, double fineness) { return {rounded(spot.x, fineness), rounded(spot.y, fineness)}; }

bool draws(const Outline& outline, const Stroke& stroke)
{
    return in_range(outline) && scene::quantized(outline) == stroke;
}

Vec2 spot_of(scene::Point point) { return {point.x / 16.0, point.y / 16.0}; }

/// The box about the points where curves begin and end.
struct Box {
    Vec2 low;
    Vec2 high;
};

Box box_of(const Outline& outline)
{
    Box box{outline.from, outline.from};
    for (const scene::Curve& curve : outline.curves) {
        box.low = {std::min(box.low.x, curve.to.x), std::min(box.low.y, curve.to.y)};
        box.high = {std::max(box.high.x, curve.to.x), std::max(box.high.y, curve.to.y)};
    }
    return box;
}

std::optional<ShapeForm> round_form(const Box& box, const Stroke& stroke, double fineness)
{
    const Vec2 centre = rounded(0.5 * (box.low + box.high), fineness);
    const Vec2 radii = rounded(0.5 * (box.high - box.low), fineness);
    if (draws(scene::ellipse(centre, radii.x, radii.x), stroke))
        return CircleForm{centre, radii.x};
    if (draws(scene::ellipse(centre, radii.x, radii.y), stroke))
        return EllipseForm{centre, radii.x, radii.y};
    return std::nullopt;
}

/// The larger of both radii: the other one is cut to half of its side. Where corners take all of the upper
/// side, the first curve is a corner already.
double corner_radius(const Outline& outline, const Box& box)
{
    const Vec2 corner_end = outline.curves[outline.curves[0].cubic ? 0 : 1].to;
    return std::max(outline.from.x - box.low.x, corner_end.y - box.low.y);
}

std::optional<ShapeForm> rect_form(double radius, const Box& box, const Stroke& stroke, double fineness)
{
    const Vec2 corner = rounded(box.low, fineness);
    const Vec2 size = rounded(box.high - box.low, fineness);
    radius = rounded(radius, fineness);
    if (draws(scene::rectangle(corner, size.x, size.y, radius), stroke))
        return RectForm{corner, size.x, size.y, radius};
    return std::nullopt;
}

/// The first form that `form_with` returns, with the fewest decimals.
template <typename FormWith>
ShapeForm first_form(const FormWith& form_with)
{
    for (const double fineness : finenesses)
        if (auto form = form_with(fineness))
            return *std::move(form);
    return PathForm{};
}

ShapeForm straight_form(const Stroke& stroke, const Box& box)
{
    const bool closed = stroke.segments.back().to == stroke.from;
    if (closed && stroke.segments.size() == 4) {
        auto rect = first_form([&](double fineness) { return rect_form(0, box, stroke, fineness); });
        if (!std::holds_alternative<PathForm>(rect))
            return rect;
    }
    std::vector<Vec2> spots{spot_of(stroke.from)};
    for (const scene::Segment& segment : stroke.segments)
        spots.push_back(spot_of(segment.to));
    if (!closed)
        return LineForm{std::move(spots)};
    spots.pop_back();
    // There and back is a line with three points: a polygon has three corners.
    if (spots.size() < 3)
        return LineForm{{spots[0], spots[1], spots[0]}};
    return PolygonForm{std::move(spots)};
}

bool all(const Stroke& stroke, bool cubic)
{
    return std::ranges::all_of(stroke.segments, [=](const auto& segment) { return segment.cubic == cubic; });
}

}

ShapeForm shape_form(const Outline& outline)
{
    if (!in_range(outline))
        return PathForm{};
    const Stroke stroke = scene::quantized(outline);
    const Box box = box_of(outline);
    if (stroke.segments.empty())
        return PathForm{};
    if (all(stroke, false))
        return straight_form(stroke, box);
    if (stroke.segments.size() == 4 && all(stroke, true))
        if (auto form = first_form([&](double fineness) { return round_form(box, stroke, fineness); });
            !std::holds_alternative<PathForm>(form))
            return form;
    if (stroke.segments.size() < 4 || stroke.segments.size() > 8 || outline.curves.size() < 2)
        return PathForm{};
    const double radius = corner_radius(outline, box);
    return first_form([&](double fineness) { return rect_form(radius, box, stroke, fineness); });
}

}

#include "host/lottie/drawings/coverage.hpp"

#include "host/art/document/matrix_at.hpp"

namespace kfast::lottie {
namespace {

using art::Affine;
using scene::Vec2;

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

/// Of its light, as in sRGB's own weights; 1 without.
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
        if (!box_at({&node, 1}, time, matrix).touches(box_around(polygon)))
            coverage = Coverage::nothing;
        else if (fill <= 1 - nearly_all && !shape.stroke)
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
    // Something dark may lie over something bright.
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

#pragma once

#include "host/art/budget.hpp"
#include "host/art/document/document.hpp"
#include "host/art/geometry/affine.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

namespace kfast::lottie {

/// Nothing while `left` is not below `right`.
struct Box {
    double left = std::numeric_limits<double>::infinity();
    double top = std::numeric_limits<double>::infinity();
    double right = -std::numeric_limits<double>::infinity();
    double bottom = -std::numeric_limits<double>::infinity();

    bool empty() const { return !(left < right && top < bottom); }
    void include(scene::Vec2 spot);
    /// Leaves a breadth of 1/100 px aside.
    bool lies_within(const Box& other) const;
    bool touches(const Box& other) const;
    std::vector<scene::Vec2> corners() const;
};

/// Around all control points and widths of lines that are seen at the time, in the coordinates of `matrix`.
Box box_at(std::span<const art::Node> nodes, double time, const art::Affine& matrix = {});

/// Whether the polygon or curve contains the whole of a convex polygon, such as a box that has been turned.
bool contains(const art::Drawing& drawing, std::span<const scene::Vec2> polygon);

/// How many points have to be computed to know how nodes, or a transform, are at a moment; at least one for
/// each.
std::size_t weight(std::span<const art::Node> nodes);
std::size_t weight(const art::Transform& transform);

/// Moments of a span to look at, both ends among them; fewer of what has more weight. Throws Failure when too
/// much is computed.
std::vector<double> sample_times(const art::Span& span, std::size_t weight, art::Budget& budget);

/// How much of something is covered.
enum class Coverage { all, nothing, part };

Coverage inverted(Coverage coverage);

/// Of a box by a filled drawing.
Coverage coverage_of(const Box& box, const art::Drawing& drawing);

/// Of a polygon by what nodes paint without being seen through; if `by_luminance`, by white without it.
Coverage coverage_of(std::span<const scene::Vec2> polygon, std::span<const art::Node> nodes,
                     const art::Affine& matrix, double time, bool by_luminance);

}

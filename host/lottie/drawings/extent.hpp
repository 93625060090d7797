#pragma once

#include "host/art/budget.hpp"
#include "host/art/document/document.hpp"
#include "host/art/geometry/affine.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

namespace kfast::lottie {

/// Empty while `left` is not below `right`.
struct Box {
    double left = std::numeric_limits<double>::infinity();
    double top = std::numeric_limits<double>::infinity();
    double right = -std::numeric_limits<double>::infinity();
    double bottom = -std::numeric_limits<double>::infinity();

    bool empty() const { return !(left < right && top < bottom); }
    void include(scene::Vec2 spot);
    void unite(const Box& other);
    /// Ignores a margin of 1/100 px.
    bool lies_within(const Box& other) const;
    bool touches(const Box& other) const;
    std::vector<scene::Vec2> corners() const;
};

/// The box around all control points and line widths that are visible at the time, transformed by `matrix`.
/// `of_symbols` are the boxes of the symbols that are used, around all that they ever draw.
Box box_at(std::span<const art::Node> nodes, double time, const art::Affine& matrix = {},
           std::span<const Box> of_symbols = {});

/// The box around all that was visible at some moments of a span.
Box box_in(std::span<const art::Node> nodes, const art::Span& span, std::span<const Box> of_symbols,
           art::Budget& budget);

/// Whether the polygon or curve contains the whole of a convex polygon, such as a rotated box.
bool contains(const art::Drawing& drawing, std::span<const scene::Vec2> polygon);

/// How many points have to be computed to evaluate nodes, or a transform, at one time; at least one for
/// each.
std::size_t weight(std::span<const art::Node> nodes);
std::size_t weight(const art::Transform& transform);

/// Times of a span to sample, both ends among them; fewer for what has more weight. Throws Failure when too
/// much is computed.
std::vector<double> sample_times(const art::Span& span, std::size_t weight, art::Budget& budget);

/// How much of something is covered.
enum class Coverage { all, nothing, part };

Coverage inverted(Coverage coverage);

/// The coverage of a box by a filled drawing.
Coverage coverage_of(const Box& box, const art::Drawing& drawing);

/// The coverage of a polygon by what nodes paint opaquely; if `by_luminance`, in opaque white.
Coverage coverage_of(std::span<const scene::Vec2> polygon, std::span<const art::Node> nodes,
                     const art::Affine& matrix, double time, bool by_luminance);

}

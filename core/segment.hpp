#pragma once

#include "core/point.hpp"

#include <cstdint>

namespace kfast {

/// One piece of a stroke: a straight line, or a cubic Bezier curve with the control points c1 and c2.
struct Segment {
    enum class Kind : std::uint8_t { line, cubic };

    Kind kind = Kind::line;
    Point from = {};
    Point c1 = {}; ///< only of cubics
    Point c2 = {};
    Point to = {};

    friend constexpr bool operator==(const Segment&, const Segment&) = default;
};

/// A segment that stays at one point.
constexpr Segment still_segment(Point at) { return {.from = at, .to = at}; }

/// The stretch of `whole` between two shares of its parameter; curves by de Casteljau's construction. Two
/// stretches that share an end share its very bits.
Segment stretch(const Segment& whole, Share begin, Share end);

/// The point on `segment` at a share of its parameter.
Point point_at(const Segment& segment, Share share);

/// Between two segments, with separate shares of the way for x and y. A line paired with a curve becomes a
/// curve, its control points at the thirds.
Segment tween(const Segment& a, const Segment& b, Share x, Share y);

}

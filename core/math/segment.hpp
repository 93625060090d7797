#pragma once

#include "core/math/point.hpp"

#include <cstdint>

namespace kfast {

/// One piece of a stroke: a straight line, or a cubic Bezier curve with the control points c1 and c2.
///
/// The functions below need all points of a segment, and of both segments of a tween, to lie less than
/// 32768 px apart in x and in y; nothing is checked. Drawings within ±16383 px always do, and drawings within
/// ±4095 px can also be tweened by ways beyond 0 … 1 and then be divided.
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

/// A line as a curve, its control points at the thirds to 1/65536 of its length.
[[gnu::cold]] Segment as_cubic(const Segment& segment);

/// With all points rounded to 1/64 px, halves up.
[[gnu::cold]] Segment rounded_to_grid(const Segment& segment);

/// The stretch of `whole` between two shares of its parameter; curves by de Casteljau's construction, each
/// point within 2/65536 px. Two stretches that share an end share its very bits.
[[gnu::cold]] Segment stretch(const Segment& whole, Fraction begin, Fraction end);

/// The point on `segment` at a share of its parameter, within 2/65536 px; on a line rounded once.
Point point_at(const Segment& segment, Fraction fraction);

/// Between two segments of one kind, with separate ways for x and y, which may lead beyond either; rounded
/// once, each end exact.
Segment tween(const Segment& a, const Segment& b, Progress x, Progress y);

}

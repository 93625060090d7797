#pragma once

#include "host/geometry/outline.hpp"

/// A segment of a stroke before rounding, with its length: what is divided by length.
///
/// Only operations that every machine rounds alike are used, so that a scene compiles to the same bytes
/// everywhere.
namespace kfast {

using scene::Vec2;

/// In pixels. A line's control points are not looked at.
struct MeasuredSegment {
    bool cubic = false;
    Vec2 from;
    Vec2 c1;
    Vec2 c2;
    Vec2 to;
    double length = 0;
};

/// The point at a share of the way from `a` to `b`; exact at 0 and 1.
Vec2 between(Vec2 a, Vec2 b, double share);

/// Sets the length. A curve's is that of 32 chords: for a quarter of a circle 1/10000 too short.
MeasuredSegment measured(MeasuredSegment segment);

/// How far apart the points at the same share of parameter and of length are at most, along the segment.
double unevenness(const MeasuredSegment& segment);

/// The point at a share of the length.
Vec2 spot_at(const MeasuredSegment& segment, double share);

/// The stretch between two shares of the length; it has the same points in common with its neighbour that
/// begins where it ends, to the bit.
MeasuredSegment stretch(const MeasuredSegment& whole, double begin, double end);

MeasuredSegment reversed(const MeasuredSegment& segment);

/// Where it leads from its first point; (0, 0) if it has no extent.
Vec2 direction(const MeasuredSegment& segment);

}

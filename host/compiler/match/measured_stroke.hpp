#pragma once

#include "host/geometry/outline.hpp"

#include <cstddef>
#include <span>
#include <vector>

/// A segment of a stroke before rounding, with its length: what is divided by length.
///
/// Only operations that every machine rounds identically are used, so that a scene compiles to the same bytes
/// everywhere.
namespace kfast {

using scene::Vec2;

/// In pixels. A line's control points are ignored.
struct MeasuredSegment {
    bool cubic = false;
    Vec2 from;
    Vec2 c1;
    Vec2 c2;
    Vec2 to;
    double length = 0;
};

/// The point at a fraction of the line from `a` to `b`; exact at 0 and 1.
Vec2 between(Vec2 a, Vec2 b, double share);

/// Sets the length. That of a curve is that of 32 chords: for a quarter of a circle 1/10000 too short.
MeasuredSegment measured(MeasuredSegment segment);

/// How far apart the points at the same fraction of parameter and of length are at most, along the segment.
double unevenness(const MeasuredSegment& segment);

/// The point at a fraction of the length.
Vec2 spot_at(const MeasuredSegment& segment, double share);

/// The part between two fractions of the length; it shares its end with the neighbour that begins there, bit
/// for bit.
MeasuredSegment subsegment(const MeasuredSegment& whole, double begin, double end);

MeasuredSegment reversed(const MeasuredSegment& segment);

/// Its direction from its first point; (0, 0) if it has no extent.
Vec2 direction(const MeasuredSegment& segment);

/// A stroke before rounding. A single point has no segments, and that is all that is known of it here.
using MeasuredStroke = std::vector<MeasuredSegment>;

/// A point on a stroke: a segment and a fraction of its length. {number of segments, 0} is the last point.
struct StrokePlace {
    std::size_t segment = 0;
    double share = 0;
};

Vec2 in_pixels(scene::Point point);

MeasuredStroke measured(const scene::Stroke& stroke);

/// Rounds every point once, to the nearest 1/16 px (halves away from zero). `stroke` has a segment. Segments
/// that lose their extent are kept.
scene::Stroke rounded(const MeasuredStroke& stroke);

bool is_closed(const MeasuredStroke& stroke);

double length_of(const MeasuredStroke& stroke);

/// How far along the stroke its vertices are, as fractions of its length: 0 for the first point, 1 for the
/// last. Never falls. `stroke` has a segment.
std::vector<double> positions_of(const MeasuredStroke& stroke);

/// How far `position` is from `begin` to `end`, 0 … 1; 0 if those are the same.
double share_between(double begin, double end, double position);

/// Where `position` is, 0 … 1; `positions` are those of the vertices.
StrokePlace place_at(std::span<const double> positions, double position);

/// Points at even distances along the stroke. The outer ones are half a step from its ends, so that those of
/// the reversed stroke are the same in reverse. `stroke` has a segment.
std::vector<Vec2> samples_of(const MeasuredStroke& stroke, std::size_t count);

/// The part between two places, the first of which is not after the second.
MeasuredStroke part_of(const MeasuredStroke& stroke, StrokePlace begin, StrokePlace end);

/// A closed stroke that begins elsewhere.
MeasuredStroke begun_at(const MeasuredStroke& closed, StrokePlace start);

MeasuredStroke reversed(const MeasuredStroke& stroke);

/// The stroke with a vertex at each of the places, and only there. They rise from the first point to the
/// last, and all vertices are among them.
MeasuredStroke divided(const MeasuredStroke& stroke, std::span<const StrokePlace> places);

/// `stroke`, its curves divided until, in each segment, the points at the same fraction of parameter and of
/// length are no more than 1/32 px apart, or it is shorter than 2 px.
MeasuredStroke made_even(const MeasuredStroke& stroke);

}

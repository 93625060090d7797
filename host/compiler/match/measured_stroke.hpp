#pragma once

#include "host/compiler/match/measured_segment.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace kfast {

/// A stroke before rounding. A single point has no segments, and that is all that is known of it here.
using MeasuredStroke = std::vector<MeasuredSegment>;

/// A point on a stroke: a segment and a share of its length. {number of segments, 0} is the last point.
struct StrokePlace {
    std::size_t segment = 0;
    double share = 0;
};

Vec2 in_pixels(scene::Point point);

MeasuredStroke measured(const scene::Stroke& stroke);

/// Rounds every point once, to the nearest 1/16 px (halves away from zero). `stroke` has a segment. Segments
/// that lose their extent stay.
scene::Stroke rounded(const MeasuredStroke& stroke);

bool is_closed(const MeasuredStroke& stroke);

double length_of(const MeasuredStroke& stroke);

/// How far along the stroke its vertices are, as shares of its length: 0 for the first point, 1 for the last.
/// Never falls. `stroke` has a segment.
std::vector<double> positions_of(const MeasuredStroke& stroke);

/// How far `position` is from `begin` to `end`, 0 … 1; 0 if there is no way between them.
double share_between(double begin, double end, double position);

/// Where `position` is, 0 … 1; `positions` are those of the vertices.
StrokePlace place_at(std::span<const double> positions, double position);

/// Points at even distances along the stroke. They lie half a step from its ends, so that those of the
/// reversed stroke are the same in reverse. `stroke` has a segment.
std::vector<Vec2> samples_of(const MeasuredStroke& stroke, std::size_t count);

/// The part between two places, the first of which is not behind the second.
MeasuredStroke part_of(const MeasuredStroke& stroke, StrokePlace begin, StrokePlace end);

/// A closed stroke that begins elsewhere.
MeasuredStroke begun_at(const MeasuredStroke& closed, StrokePlace start);

MeasuredStroke reversed(const MeasuredStroke& stroke);

/// The stroke with a vertex at each of the places, and only there. They rise from the first point to the
/// last, and all vertices are among them.
MeasuredStroke divided(const MeasuredStroke& stroke, std::span<const StrokePlace> places);

}

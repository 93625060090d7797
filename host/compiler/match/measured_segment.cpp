#include "host/compiler/match/measured_segment.hpp"

#include <algorithm>
#include <cmath>

namespace kfast {
namespace {

constexpr int chords = 32;

/// The polar form of a cubic: blossom(t, t, t) is the point at t.
Vec2 blossom(const MeasuredSegment& cubic, double r, double s, double t)
{
    const Vec2 a = between(cubic.from, cubic.c1, r);
    const Vec2 b = between(cubic.c1, cubic.c2, r);
    const Vec2 c = between(cubic.c2, cubic.to, r);
    return between(between(a, b, s), between(b, c, s), t);
}

Vec2 at_parameter(const MeasuredSegment& segment, double t)
{
    return segment.cubic ? blossom(segment, t, t, t) : between(segment.from, segment.to, t);
}

/// Of a cubic. Walks along the chords and divides the one that it ends in evenly.
double parameter_at(const MeasuredSegment& cubic, double share)
{
    double left = share * cubic.length;
    Vec2 at = cubic.from;
    for (int i = 0; i < chords && share < 1; ++i) {
        const Vec2 next = at_parameter(cubic, (i + 1.0) / chords);
        const double chord = distance(at, next);
        if (left < chord)
            return (i + left / chord) / chords;
        left -= chord;
        at = next;
    }
    return 1;
}

}

Vec2 between(Vec2 a, Vec2 b, double share) { return (1 - share) * a + share * b; }

MeasuredSegment measured(MeasuredSegment segment)
{
    segment.length = 0;
    const int count = segment.cubic ? chords : 1;
    Vec2 at = segment.from;
    for (int i = 1; i <= count; ++i) {
        const Vec2 next = at_parameter(segment, static_cast<double>(i) / count);
        segment.length += distance(at, next);
        at = next;
    }
    return segment;
}

double unevenness(const MeasuredSegment& segment)
{
    if (!segment.cubic)
        return 0;
    double max = 0;
    double length = 0;
    Vec2 at = segment.from;
    for (int i = 1; i < chords; ++i) {
        const double share = static_cast<double>(i) / chords;
        const Vec2 next = at_parameter(segment, share);
        length += distance(at, next);
        max = std::max(max, std::abs(length - share * segment.length));
        at = next;
    }
    return max;
}

Vec2 spot_at(const MeasuredSegment& segment, double share)
{
    return at_parameter(segment, segment.cubic ? parameter_at(segment, share) : share);
}

MeasuredSegment stretch(const MeasuredSegment& whole, double begin, double end)
{
    if (begin == 0 && end == 1)
        return whole;
    MeasuredSegment part = whole;
    part.from = spot_at(whole, begin);
    part.to = spot_at(whole, end);
    if (whole.cubic) {
        const double from = parameter_at(whole, begin);
        const double to = parameter_at(whole, end);
        part.c1 = blossom(whole, from, from, to);
        part.c2 = blossom(whole, from, to, to);
    }
    return measured(part);
}

MeasuredSegment reversed(const MeasuredSegment& segment)
{
    return {segment.cubic, segment.to, segment.c2, segment.c1, segment.from, segment.length};
}

Vec2 direction(const MeasuredSegment& segment)
{
    const auto has_extent = [](Vec2 spot) { return spot.x != 0 || spot.y != 0; };
    if (segment.cubic && has_extent(segment.c1 - segment.from))
        return segment.c1 - segment.from;
    if (segment.cubic && has_extent(segment.c2 - segment.from))
        return segment.c2 - segment.from;
    return segment.to - segment.from;
}

}

#include "host/compiler/match/measured_stroke.hpp"

#include "host/geometry/drawing.hpp"

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

/// The parameter of a cubic. Walks along the chords and divides the one that it ends in evenly.
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

MeasuredSegment subsegment(const MeasuredSegment& whole, double begin, double end)
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

namespace {

scene::Point rounded(Vec2 spot) { return {scene::to_sixteenths(spot.x), scene::to_sixteenths(spot.y)}; }

scene::Segment rounded(const MeasuredSegment& segment)
{
    if (!segment.cubic)
        return {.cubic = false, .c1 = {}, .c2 = {}, .to = rounded(segment.to)};
    return {.cubic = true, .c1 = rounded(segment.c1), .c2 = rounded(segment.c2), .to = rounded(segment.to)};
}

}

Vec2 in_pixels(scene::Point point) { return {point.x / 16.0, point.y / 16.0}; }

MeasuredStroke measured(const scene::Stroke& stroke)
{
    MeasuredStroke result;
    result.reserve(stroke.segments.size());
    scene::Point at = stroke.from;
    for (const scene::Segment& segment : stroke.segments) {
        result.push_back(measured({.cubic = segment.cubic,
                                   .from = in_pixels(at),
                                   .c1 = in_pixels(segment.c1),
                                   .c2 = in_pixels(segment.c2),
                                   .to = in_pixels(segment.to)}));
        at = segment.to;
    }
    return result;
}

scene::Stroke rounded(const MeasuredStroke& stroke)
{
    scene::Stroke result{.from = rounded(stroke.front().from), .segments = {}};
    result.segments.reserve(stroke.size());
    for (const MeasuredSegment& segment : stroke)
        result.segments.push_back(rounded(segment));
    return result;
}

bool is_closed(const MeasuredStroke& stroke)
{
    return !stroke.empty() && stroke.front().from.x == stroke.back().to.x &&
           stroke.front().from.y == stroke.back().to.y;
}

double length_of(const MeasuredStroke& stroke)
{
    double length = 0;
    for (const MeasuredSegment& segment : stroke)
        length += segment.length;
    return length;
}

std::vector<double> positions_of(const MeasuredStroke& stroke)
{
    const double whole = length_of(stroke);
    std::vector<double> positions{0};
    double length = 0;
    for (const MeasuredSegment& segment : stroke) {
        length += segment.length;
        positions.push_back(share_between(0, whole, length));
    }
    return positions;
}

double share_between(double begin, double end, double position)
{
    return end > begin ? std::clamp((position - begin) / (end - begin), 0.0, 1.0) : 0;
}

StrokePlace place_at(std::span<const double> positions, double position)
{
    const auto inner = positions.subspan(1, positions.size() - 2);
    const auto segment = static_cast<std::size_t>(std::ranges::upper_bound(inner, position) - inner.begin());
    return {segment, share_between(positions[segment], positions[segment + 1], position)};
}

std::vector<Vec2> samples_of(const MeasuredStroke& stroke, std::size_t count)
{
    const std::vector<double> positions = positions_of(stroke);
    std::vector<Vec2> samples;
    samples.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double position = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
        const StrokePlace place = place_at(positions, position);
        samples.push_back(spot_at(stroke[place.segment], place.share));
    }
    return samples;
}

MeasuredStroke part_of(const MeasuredStroke& stroke, StrokePlace begin, StrokePlace end)
{
    MeasuredStroke part;
    for (std::size_t i = begin.segment; i <= end.segment && i < stroke.size(); ++i) {
        const double from = i == begin.segment ? begin.share : 0;
        const double to = i == end.segment ? end.share : 1;
        if (from < to)
            part.push_back(subsegment(stroke[i], from, to));
    }
    return part;
}

MeasuredStroke begun_at(const MeasuredStroke& closed, StrokePlace start)
{
    MeasuredStroke result = part_of(closed, start, {closed.size(), 0});
    const MeasuredStroke rest = part_of(closed, {}, start);
    result.insert(result.end(), rest.begin(), rest.end());
    return result;
}

MeasuredStroke reversed(const MeasuredStroke& stroke)
{
    MeasuredStroke result;
    result.reserve(stroke.size());
    for (auto segment = stroke.rbegin(); segment != stroke.rend(); ++segment)
        result.push_back(reversed(*segment));
    return result;
}

MeasuredStroke divided(const MeasuredStroke& stroke, std::span<const StrokePlace> places)
{
    MeasuredStroke result;
    result.reserve(places.size() - 1);
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        const auto [segment, begin] = places[i];
        const double end = places[i + 1].segment == segment ? places[i + 1].share : 1;
        result.push_back(subsegment(stroke[segment], begin, end));
    }
    return result;
}

namespace {

constexpr double tolerance = 1.0 / 32;
constexpr double shortest_divided = 2;

void append(MeasuredStroke& stroke, const MeasuredSegment& segment)
{
    if (segment.length < shortest_divided || unevenness(segment) <= tolerance) {
        stroke.push_back(segment);
        return;
    }
    append(stroke, subsegment(segment, 0, 0.5));
    append(stroke, subsegment(segment, 0.5, 1));
}

}

MeasuredStroke made_even(const MeasuredStroke& stroke)
{
    MeasuredStroke even;
    for (const MeasuredSegment& segment : stroke)
        append(even, segment);
    return even;
}

}

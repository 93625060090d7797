#include "host/compiler/match/measured_stroke.hpp"

#include "host/geometry/coordinate.hpp"

#include <algorithm>

namespace kfast {
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
            part.push_back(stretch(stroke[i], from, to));
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
        result.push_back(stretch(stroke[segment], begin, end));
    }
    return result;
}

}

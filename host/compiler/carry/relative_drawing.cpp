#include "host/compiler/carry/relative_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kfast {
namespace {

constexpr std::uint32_t min_unit_bits = 4;
constexpr std::uint32_t max_unit_bits = 15;

RelativeStroke relative_stroke(const std::vector<Segment>& stroke, const BackboneCells& cells)
{
    const std::int32_t main = cells.main_backbone(spots_of(stroke));
    RelativeStroke relative{cells.place_of(in_pixels(stroke.front().from), main), {}};
    std::int32_t backbone = relative.from.backbone;
    for (const Segment& segment : stroke) {
        RelativeSegment& added = relative.segments.emplace_back();
        added.to = cells.place_of(in_pixels(segment.to), main);
        added.cubic = segment.kind == Segment::Kind::cubic;
        if (added.cubic) {
            added.c1 = cells.place_on(in_pixels(segment.c1), backbone);
            added.c2 = cells.place_on(in_pixels(segment.c2), added.to.backbone);
        }
        backbone = added.to.backbone;
    }
    return relative;
}

/// A point in the units that are stored.
struct Stored {
    long x;
    long y;
};

Stored stored(const RelativePoint& point, std::uint32_t unit_bits)
{
    const double unit = std::ldexp(1, static_cast<int>(unit_bits));
    return {std::min(std::lround(point.along * unit), std::lround(point.limit * unit) - 1),
            std::lround(point.across * unit)};
}

bool fits(const RelativePoint& point, std::uint32_t unit_bits)
{
    const auto fits = [](long value) {
        return value >= std::numeric_limits<std::int16_t>::min() &&
               value <= std::numeric_limits<std::int16_t>::max();
    };
    const auto [x, y] = stored(point, unit_bits);
    return fits(x) && fits(y);
}

bool fits(const RelativeStroke& stroke, std::uint32_t unit_bits)
{
    return fits(stroke.from, unit_bits) &&
           std::ranges::all_of(stroke.segments, [unit_bits](const RelativeSegment& segment) {
               return fits(segment.c1, unit_bits) && fits(segment.c2, unit_bits) &&
                      fits(segment.to, unit_bits);
           });
}

scene::Point rounded(const RelativePoint& point, std::uint32_t unit_bits)
{
    const auto [x, y] = stored(point, unit_bits);
    return {static_cast<std::int16_t>(x), static_cast<std::int16_t>(y)};
}

scene::Segment rounded(const RelativeSegment& segment, std::uint32_t unit_bits)
{
    if (!segment.cubic)
        return {.cubic = false, .c1 = {}, .c2 = {}, .to = rounded(segment.to, unit_bits)};
    return {true, rounded(segment.c1, unit_bits), rounded(segment.c2, unit_bits),
            rounded(segment.to, unit_bits)};
}

}

RelativeDrawing relative_drawing(const SegmentDrawing& drawing, const BackboneCells& cells)
{
    RelativeDrawing relative;
    for (const std::vector<Segment>& stroke : drawing)
        relative.push_back(relative_stroke(stroke, cells));
    return relative;
}

std::vector<Vec2> spots_of(const std::vector<Segment>& stroke)
{
    std::vector<Vec2> spots{in_pixels(stroke.front().from)};
    for (const Segment& segment : stroke)
        spots.push_back(in_pixels(segment.to));
    return spots;
}

std::uint32_t unit_bits_of(std::span<const RelativeDrawing> drawings)
{
    std::uint32_t bits = max_unit_bits;
    for (const RelativeDrawing& drawing : drawings)
        for (const RelativeStroke& stroke : drawing)
            while (bits > min_unit_bits && !fits(stroke, bits))
                --bits;
    return bits;
}

scene::Drawing rounded(const RelativeDrawing& drawing, std::uint32_t unit_bits)
{
    scene::Drawing result;
    for (const RelativeStroke& stroke : drawing) {
        scene::Stroke& added = result.strokes.emplace_back();
        added.from = rounded(stroke.from, unit_bits);
        for (const RelativeSegment& segment : stroke.segments)
            added.segments.push_back(rounded(segment, unit_bits));
    }
    return result;
}

}

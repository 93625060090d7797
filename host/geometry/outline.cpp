#include "host/geometry/outline.hpp"

#include "host/geometry/drawing.hpp"

#include <algorithm>

namespace kfast::scene {

namespace {

Point rounded(Vec2 spot) { return {to_sixteenths(spot.x), to_sixteenths(spot.y)}; }

Segment rounded(const Curve& curve)
{
    if (!curve.cubic)
        return {.cubic = false, .c1 = {}, .c2 = {}, .to = rounded(curve.to)};
    return {.cubic = true, .c1 = rounded(curve.c1), .c2 = rounded(curve.c2), .to = rounded(curve.to)};
}

bool has_extent(Point from, const Segment& segment)
{
    return segment.to != from || (segment.cubic && (segment.c1 != from || segment.c2 != from));
}

void append(Stroke& stroke, Point& end, const Segment& segment)
{
    if (!has_extent(end, segment))
        return;
    stroke.segments.push_back(segment);
    end = segment.to;
}

}

bool in_range(Vec2 spot) { return in_range(spot.x) && in_range(spot.y); }

bool in_range(const Curve& curve)
{
    return in_range(curve.to) && (!curve.cubic || (in_range(curve.c1) && in_range(curve.c2)));
}

bool in_range(const Outline& outline)
{
    return in_range(outline.from) &&
           std::ranges::all_of(outline.curves, [](const Curve& curve) { return in_range(curve); });
}

Stroke quantized(const Outline& outline)
{
    Stroke stroke{.from = rounded(outline.from), .segments = {}};
    stroke.segments.reserve(outline.curves.size());
    Point end = stroke.from;
    for (const Curve& curve : outline.curves)
        append(stroke, end, rounded(curve));
    if (outline.closed)
        append(stroke, end, rounded(line_to(outline.from)));
    return stroke;
}

}

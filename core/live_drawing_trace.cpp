#include "core/live_drawing_trace.hpp"

#include "core/point_map.hpp"
#include "core/work.hpp"

namespace kfast {
namespace {

Point point_of(LivePoint point) { return {Fixed::sixteenths(point.x), Fixed::sixteenths(point.y)}; }

void trace(LiveStroke stroke, const PointMap& place, ObjectOutline& outline)
{
    did(Work::stroke);
    const Point first = place(point_of(stroke.front()));
    outline.begin(first);
    Point from = first;
    for (const LivePoint& point : stroke.subspan(1)) {
        did(Work::line);
        const Point to = place(point_of(point));
        outline.add({.from = from, .to = to});
        from = to;
    }
    outline.end(first, stroke.front() == stroke.back());
}

}

Point start_of(const LiveDrawing& drawing)
{
    return drawing.strokes() == 0 ? Point{} : point_of(drawing.stroke(0).front());
}

void trace_live_strokes(const LiveDrawing& drawing, const Affine& placement, ObjectOutline& outline)
{
    const PointMap place{placement};
    for (std::uint32_t number = 0; number < drawing.strokes(); ++number)
        trace(drawing.stroke(number), place, outline);
}

}

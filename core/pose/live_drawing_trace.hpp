#pragma once

#include "core/bytes/work.hpp"
#include "core/math/affine.hpp"
#include "core/math/point.hpp"
#include "core/math/point_map.hpp"
#include "core/math/segment.hpp"
#include "core/pose/live_drawing.hpp"

#include <cstdint>

namespace kfast {

constexpr Point point_of(LivePoint point) { return {Fixed::sixteenths(point.x), Fixed::sixteenths(point.y)}; }

/// Where the drawing that is shown begins; the origin if it is empty.
inline Point start_of(const LiveDrawing& drawing)
{
    return drawing.strokes() == 0 ? Point{} : point_of(drawing.stroke(0).front());
}

/// Adds the strokes that are shown, placed.
template <class Outline>
void trace_live_strokes(const LiveDrawing& drawing, const Affine& placement, Outline& outline)
{
    const PointMap place{placement};
    for (std::uint32_t number = 0; number < drawing.strokes(); ++number) {
        did(Work::stroke);
        const LiveStroke stroke = drawing.stroke(number);
        const Point first = place(point_of(stroke.front()));
        outline.begin(first);
        Point from = first;
        for (const LivePoint& point : stroke.subspan(1)) {
            did(Work::line);
            const Point to = place(point_of(point));
            outline.add(Segment{.from = from, .to = to});
            from = to;
        }
        outline.end(first, stroke.front() == stroke.back());
    }
}

}

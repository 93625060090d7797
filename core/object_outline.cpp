#include "core/object_outline.hpp"

#include <algorithm>

namespace kfast {

void ObjectOutline::begin(Point from)
{
    if (stroke_)
        stroke_->begin(seen(from));
    else
        fill_.begin(seen(from));
}

void ObjectOutline::add(const Segment& segment)
{
    flatten(segment, halvings_of(segment), [this](Point to) { line_to(to); });
}

void ObjectOutline::end(Point hub, bool is_closed)
{
    if (stroke_)
        stroke_->end(is_closed);
    else
        fill_.end(seen(hub));
}

int ObjectOutline::halvings_of(const Segment& segment) const
{
    if (segment.kind == Segment::Kind::line)
        return 0;
    const int needed = projection_ == nullptr
                           ? halvings_for(segment)
                           : halvings_for({segment.kind, seen(segment.from), seen(segment.c1),
                                           seen(segment.c2), seen(segment.to)});
    return std::max(0, needed - coarseness_);
}

void ObjectOutline::line_to(Point to)
{
    if (stroke_)
        stroke_->line_to(seen(to));
    else
        fill_.line_to(seen(to));
}

}

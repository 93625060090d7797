#include "core/object_outline.hpp"

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
    flatten(segment, pieces_of(segment), [this](Point to) { line_to(to); });
}

void ObjectOutline::end(Point hub, bool is_closed)
{
    if (stroke_)
        stroke_->end(is_closed);
    else
        fill_.end(seen(hub));
}

int ObjectOutline::pieces_of(const Segment& segment) const
{
    if (segment.kind == Segment::Kind::line)
        return 1;
    const int needed = projection_ == nullptr
                           ? pieces_for(segment)
                           : pieces_for({segment.kind, seen(segment.from), seen(segment.c1), seen(segment.c2),
                                         seen(segment.to)});
    return coarser(needed, coarseness_);
}

void ObjectOutline::line_to(Point to)
{
    if (stroke_)
        stroke_->line_to(seen(to));
    else
        fill_.line_to(seen(to));
}

}

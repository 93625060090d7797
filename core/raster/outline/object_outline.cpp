#include "core/raster/outline/object_outline.hpp"

#include "core/features.hpp"

namespace kfast {

void ObjectOutline::stroke_with(const Pen& pen, const StrokeFeature& strokes)
{
    strokes.emplace(stroke_, outlines_, pen, view_.coarseness());
}

void ObjectOutline::begin(Point from)
{
    if (trimmer_ != nullptr)
        trimmer_->begin(from);
    else
        begin_piece(from);
}

void ObjectOutline::add(const Segment& segment)
{
    if (trimmer_ != nullptr)
        trimmer_->add(segment);
    else
        add_to_piece(segment);
}

void ObjectOutline::end(Point hub, bool is_closed)
{
    if (trimmer_ != nullptr)
        trimmer_->end(hub, is_closed);
    else
        end_whole(hub, is_closed);
}

void ObjectOutline::begin_piece(Point from)
{
    if (stroke_)
        stroke_->begin(view_(from));
    else
        fill_.begin(view_(from));
}

void ObjectOutline::add_to_piece(const Segment& segment)
{
    const int pieces = view_.pieces_of(segment);
    if (stroke_)
        return stroke_->add(segment, pieces, view_);
    if (!view_.is_flat())
        return flatten(segment, pieces, [this](Point to) { fill_.line_to(view_(to)); });
    FillOutline fill = fill_; // a copy, for registers: most of what is drawn
    flatten(segment, pieces, [&fill](Point to) { fill.line_to(to); });
    fill_ = fill;
}

void ObjectOutline::end_whole(Point hub, bool is_closed)
{
    if (!stroke_)
        return fill_.end(view_(hub));
    stroke_->end(is_closed);
}

}

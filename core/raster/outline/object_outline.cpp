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
    is_at_begin_ = true;
    if (stroke_)
        stroke_->begin(view_(from));
    else
        fill_.begin(view_(from));
}

void ObjectOutline::add_to_piece(const Segment& segment)
{
    const int pieces = view_.pieces_of(segment);
    if (stroke_)
        return add_to_stroke(segment, pieces);
    if (!view_.is_flat())
        return flatten(segment, pieces, [this](Point to) { fill_.line_to(view_(to)); });
    FillOutline fill = fill_; // a copy, for registers: most of what is drawn
    flatten(segment, pieces, [&fill](Point to) { fill.line_to(to); });
    fill_ = fill;
}

void ObjectOutline::add_to_stroke(const Segment& segment, int pieces)
{
    const bool is_curve = segment.kind == Segment::Kind::cubic;
    if (is_curve && is_at_begin_)
        stroke_->set_tangent(view_(after_begin(segment)) - view_(segment.from));
    is_at_begin_ = false;
    flatten(segment, stroke_->pieces_of_rims(pieces), [this](Point to) { stroke_->line_to(view_(to)); });
    end_tangent_ = is_curve ? view_(segment.to) - view_(before_end(segment)) : Point{};
}

void ObjectOutline::end_whole(Point hub, bool is_closed)
{
    if (!stroke_)
        return fill_.end(view_(hub));
    if (!is_closed)
        stroke_->set_tangent(end_tangent_);
    stroke_->end(is_closed);
}

}

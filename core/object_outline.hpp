#pragma once

#include "core/fill_outline.hpp"
#include "core/flatten.hpp"
#include "core/projection.hpp"
#include "core/stroke_outline.hpp"

#include <algorithm>
#include <optional>

namespace kfast {

/// Feeds the live strokes of one object to its fill, or to its stroke.
class ObjectOutline {
public:
    /// Of the fill, until stroke_with() is called. Unless `projection`, which must outlive the outline, is
    /// null, the pieces of curves are projected: the projection of a curve is not the curve of the projected
    /// points. `coarseness` makes the pieces that often twice as long as the precision asks for.
    ObjectOutline(OutlineStore& outlines, const Projection* projection, int coarseness)
        : outlines_{outlines}, projection_{projection}, coarseness_{coarseness}, fill_{outlines}
    {
    }

    void stroke_with(const Pen& pen) { stroke_.emplace(outlines_, pen, coarseness_); }

    void begin(Point from);
    void add(const Segment& segment);
    void end(Point hub, bool is_closed);

private:
    Point seen(Point at) const { return projection_ == nullptr ? at : (*projection_)(at); }
    int pieces_of(const Segment& segment) const;
    void line_to(Point to);

    OutlineStore& outlines_;
    const Projection* projection_;
    int coarseness_;
    FillOutline fill_;
    std::optional<StrokeOutline> stroke_;
};

}

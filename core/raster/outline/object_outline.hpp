#pragma once

#include "core/features.hpp"
#include "core/math/sight.hpp"
#include "core/raster/outline/fill_outline.hpp"
#include "core/raster/outline/stroke_outline.hpp"

#include <optional>

namespace kfast {

/// Feeds the live strokes of one object to its fill, or to its stroke.
class ObjectOutline {
public:
    /// Of the fill, until stroke_with() is called.
    ObjectOutline(raster::OutlineStore& outlines, const Sight& sight)
        : outlines_{outlines}, sight_{sight}, fill_{outlines}
    {
    }

    void stroke_with(const Pen& pen, const StrokeFeature& strokes);

    void begin(Point from);
    void add(const Segment& segment);
    void end(Point hub, bool is_closed);

private:
    void line_to(Point seen);

    raster::OutlineStore& outlines_;
    Sight sight_;
    FillOutline fill_;
    std::optional<StrokeOutline> stroke_;
};

}

#pragma once

#include "core/raster/outline/grid.hpp"
#include "core/raster/outline/outline_store.hpp"

namespace kfast {

/// Turns the strokes of a filled drawing into contours. A stroke that is not closed is filled as if it were.
class FillOutline {
public:
    explicit FillOutline(raster::OutlineStore& outlines) : outlines_{&outlines} {}

    void begin(Point at) { start_ = last_ = raster::corner_at(at); }

    [[gnu::always_inline]] void line_to(Point to)
    {
        const raster::Corner corner = raster::corner_at(to);
        if (corner == last_)
            return;
        outlines_->add(last_);
        last_ = corner;
    }

    /// Closes the stroke by way of `hub` (docs/design.md, "Fills of broken strokes").
    void end(Point hub)
    {
        if (raster::corner_at(hub) != start_)
            line_to(hub);
        if (last_ != start_)
            outlines_->add(last_);
        outlines_->close();
    }

private:
    raster::OutlineStore* outlines_;
    raster::Corner start_;
    raster::Corner last_; ///< not added yet: it may be the start again
};

}

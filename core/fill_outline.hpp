#pragma once

#include "core/corner_at.hpp"
#include "core/outline_store.hpp"

namespace kfast {

/// Turns the strokes of a filled drawing into contours. A stroke that is not closed is filled as if it were.
class FillOutline {
public:
    explicit FillOutline(OutlineStore& outlines) : outlines_{outlines} {}

    void begin(Point at) { start_ = last_ = corner_at(at); }

    void line_to(Point to)
    {
        const Corner corner = corner_at(to);
        if (corner == last_)
            return;
        outlines_.add(last_);
        last_ = corner;
    }

    /// Closes the stroke by way of `hub` (docs/design.md, "Fills of broken strokes").
    void end(Point hub)
    {
        if (corner_at(hub) != start_)
            line_to(hub);
        if (last_ != start_)
            outlines_.add(last_);
        outlines_.close();
    }

private:
    OutlineStore& outlines_;
    Corner start_;
    Corner last_; ///< not added yet: it may be the start again
};

}

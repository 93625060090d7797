#pragma once

#include "core/edge_list.hpp"

namespace kfast {

/// Turns the strokes of a filled drawing into edges. A stroke that is not closed is filled as if it were.
class FillOutline {
public:
    FillOutline(EdgeList& edges, Layer& layer) : edges_{edges}, layer_{layer} {}

    void begin(Point at) { start_ = last_ = at; }

    void line_to(Point to)
    {
        edges_.add(layer_, last_, to);
        last_ = to;
    }

    /// Closes the stroke by way of `hub` (docs/design.md, "Fills of broken strokes").
    void end(Point hub)
    {
        line_to(hub);
        line_to(start_);
    }

private:
    EdgeList& edges_;
    Layer& layer_;
    Point start_;
    Point last_;
};

}

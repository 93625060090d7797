#pragma once

#include "core/edge_budget.hpp"
#include "core/fill_outline.hpp"
#include "core/flatten.hpp"
#include "core/projection.hpp"
#include "core/stroke_outline.hpp"

#include <cstdint>
#include <optional>

namespace kfast {

/// Feeds the live strokes of one object to its fill, its stroke or both.
class ObjectOutline {
public:
    /// A curve is traced as `curve_pieces` straight pieces. Unless `projection`, which must outlive the
    /// outline, is null, these are projected: the projection of a curve is not the curve of the projected
    /// points.
    ObjectOutline(std::uint32_t curve_pieces, const Projection* projection)
        : curve_pieces_{curve_pieces}, projection_{projection}
    {
    }

    void fill_into(EdgeList& edges, Layer& layer) { fill_.emplace(edges, layer); }
    void stroke_into(EdgeList& edges, Layer& layer, const Pen& pen)
    {
        stroke_.emplace(edges, layer, pen);
        const auto arc = static_cast<std::uint32_t>(pen.arc_pieces);
        spare_pieces_ = static_cast<std::int32_t>(arc - 1 + arcs_within_curve(arc, curve_pieces_ - 1));
    }

    void begin(Point from)
    {
        const Point at = seen(from);
        if (fill_)
            fill_->begin(at);
        if (stroke_)
            stroke_->begin(at);
    }

    void add(const Segment& segment)
    {
        if (stroke_)
            stroke_->limit_arcs(spare_pieces_);
        flatten(segment, curve_pieces_, [this](Point end) {
            const Point to = seen(end);
            if (fill_)
                fill_->line_to(to);
            if (stroke_)
                stroke_->line_to(to);
        });
    }

    void end(Point hub, bool is_closed)
    {
        if (fill_)
            fill_->end(seen(hub));
        if (stroke_)
            stroke_->end(is_closed);
    }

private:
    Point seen(Point at) const { return projection_ == nullptr ? at : (*projection_)(at); }

    std::optional<FillOutline> fill_;
    std::optional<StrokeOutline> stroke_;
    std::uint32_t curve_pieces_;
    std::int32_t spare_pieces_ = 0; ///< that the joins of a segment may have besides one each (EdgeBudget)
    const Projection* projection_;
};

}

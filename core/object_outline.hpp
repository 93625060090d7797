#pragma once

#include "core/fill_outline.hpp"
#include "core/flatten.hpp"
#include "core/stroke_outline.hpp"

#include <cstdint>
#include <optional>

namespace kfast {

/// Feeds the live strokes of one object to its fill, its stroke or both.
class ObjectOutline {
public:
    /// A curve is traced as `curve_pieces` straight pieces.
    explicit ObjectOutline(std::uint32_t curve_pieces) : curve_pieces_{curve_pieces} {}

    void fill_into(EdgeList& edges, Layer& layer) { fill_.emplace(edges, layer); }
    void stroke_into(EdgeList& edges, Layer& layer, const Pen& pen) { stroke_.emplace(edges, layer, pen); }

    void begin(Point at)
    {
        if (fill_)
            fill_->begin(at);
        if (stroke_)
            stroke_->begin(at);
    }

    void add(const Segment& segment)
    {
        flatten(segment, curve_pieces_, [this](Point to) {
            if (fill_)
                fill_->line_to(to);
            if (stroke_)
                stroke_->line_to(to);
        });
    }

    void end(Point hub, bool is_closed)
    {
        if (fill_)
            fill_->end(hub);
        if (stroke_)
            stroke_->end(is_closed);
    }

private:
    std::optional<FillOutline> fill_;
    std::optional<StrokeOutline> stroke_;
    std::uint32_t curve_pieces_;
};

}

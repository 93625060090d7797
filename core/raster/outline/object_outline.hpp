#pragma once

#include "core/features.hpp"
#include "core/math/projection.hpp"
#include "core/math/stroke_trimmer.hpp"
#include "core/raster/outline/grid.hpp"
#include "core/raster/outline/outline_store.hpp"
#include "core/raster/outline/stroke_outline.hpp"

#include <optional>

namespace kfast {

/// Makes contours of the strokes of a filled drawing. A stroke that is not closed is filled as if it was.
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

    /// Closes the stroke by way of `hub` (core/pose/README.md, "Fills of broken strokes").
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

/// Feeds the live strokes of one object to its fill, or to its stroke.
class ObjectOutline {
public:
    /// The outline of the fill, until stroke_with() is called.
    ObjectOutline(raster::OutlineStore& outlines, const ViewProjection& view)
        : outlines_{outlines}, view_{view}, fill_{outlines}
    {
    }

    void stroke_with(const Pen& pen, const StrokeFeature& strokes);

    /// Passes what is added to `trimmer`, which adds pieces of it. Null: no longer.
    void trim_with(StrokeTrimmer* trimmer) { trimmer_ = trimmer; }

    void begin(Point from);
    void add(const Segment& segment);
    void end(Point hub, bool is_closed);

    // For what the trimmer lets through.

    // Not inlined, for those above would have copies of them.
    [[gnu::noinline]] void begin_piece(Point from);
    [[gnu::noinline]] void add_to_piece(const Segment& segment);
    [[gnu::cold]] void end_piece(Point hub, PieceEnd end);
    int pieces_of(const Segment& segment) const { return view_.pieces_of(segment); }

private:
    [[gnu::noinline]] void end_whole(Point hub, bool is_closed);

    raster::OutlineStore& outlines_;
    ViewProjection view_;
    FillOutline fill_;
    std::optional<StrokeOutline> stroke_;
    StrokeTrimmer* trimmer_ = nullptr;
};

}

#pragma once

#include "core/pose/equalize.hpp"
#include "core/scene/drawing_view.hpp"
#include "host/scene/model.hpp"

#include <vector>

namespace kfast {

/// Lets the core's algorithms read a drawing of the model, which must outlive the reader.
class ModelReader {
public:
    explicit ModelReader(const scene::Drawing& drawing) : drawing_{&drawing} {}

    std::uint32_t strokes() const { return static_cast<std::uint32_t>(drawing_->strokes.size()); }

    std::uint32_t next_stroke()
    {
        stroke_ = &drawing_->strokes[next_stroke_++];
        next_segment_ = 0;
        at_ = stroke_->from;
        return static_cast<std::uint32_t>(stroke_->segments.size());
    }

    Point start() const { return on_canvas(stroke_->from); }

    Segment next_segment()
    {
        const scene::Segment& segment = stroke_->segments[next_segment_++];
        const Segment::Kind kind = segment.cubic ? Segment::Kind::cubic : Segment::Kind::line;
        const Point from = on_canvas(at_);
        at_ = segment.to;
        return {kind, from, on_canvas(segment.c1), on_canvas(segment.c2), on_canvas(segment.to)};
    }

private:
    static Point on_canvas(scene::Point point)
    {
        return {Fixed::sixteenths(point.x), Fixed::sixteenths(point.y)};
    }

    const scene::Drawing* drawing_;
    const scene::Stroke* stroke_ = nullptr;
    std::size_t next_stroke_ = 0;
    std::size_t next_segment_ = 0;
    scene::Point at_;
};

static_assert(DrawingReader<ModelReader>);

/// Segments that become each other, in 1/65536 px and both of the same kind.
using SegmentPairs = std::vector<Pair<Segment>>;

/// What corresponds in two drawings: for each stroke of the drawing that has fewer of them, the parts that it
/// breaks into, each paired with a stroke of the other. Where both have as many, a stroke has one part.
struct MatchedSegments {
    std::vector<std::vector<SegmentPairs>> strokes;
    bool breaks_b = false; ///< it is `b` that has fewer strokes
};

/// Drawings by their segments: each stroke has at least one, for a single point is a segment without extent.
using SegmentDrawing = std::vector<std::vector<Segment>>;

std::vector<Segment> side_of(const SegmentPairs& pairs, Segment Pair<Segment>::*side);

/// By the rules of core/pose/equalize.hpp; what is added there, also to an empty drawing, is in the result. A
/// line that is paired with a curve is a curve. Two empty drawings have no strokes.
MatchedSegments match_by_count(const scene::Drawing& a, const scene::Drawing& b);

/// The two drawings, such that equalization pairs their segments in the same way without adding a point:
/// where a stroke breaks, all of its parts get as many segments as the largest.
Pair<SegmentDrawing> joined(const MatchedSegments& matched);

}

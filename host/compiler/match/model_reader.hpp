#pragma once

#include "core/scene/drawing_view.hpp"
#include "host/scene/model.hpp"

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

}

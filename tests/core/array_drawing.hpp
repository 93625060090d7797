#pragma once

#include "core/scene/drawing_view.hpp"

#include <vector>

namespace kfast::test {

/// A stroke in memory; no segments for a single point.
struct ArrayStroke {
    Point start;
    std::vector<Segment> segments;
};

using ArrayDrawing = std::vector<ArrayStroke>;

/// Reads an ArrayDrawing that outlives it.
class ArrayReader {
public:
    explicit ArrayReader(const ArrayDrawing& drawing) : drawing_{&drawing} {}

    std::uint32_t strokes() const { return static_cast<std::uint32_t>(drawing_->size()); }

    std::uint32_t next_stroke()
    {
        stroke_ = &(*drawing_)[next_++];
        segment_ = 0;
        return static_cast<std::uint32_t>(stroke_->segments.size());
    }

    Point start() const { return stroke_->start; }
    Segment next_segment() { return stroke_->segments.at(segment_++); }

private:
    const ArrayDrawing* drawing_;
    const ArrayStroke* stroke_ = nullptr;
    std::size_t next_ = 0;
    std::size_t segment_ = 0;
};

static_assert(DrawingReader<ArrayReader>);

inline Point pixels(double x, double y)
{
    const auto fixed = [](double value) {
        return Fixed::from_raw(static_cast<std::int32_t>(value * Fixed::one));
    };
    return {fixed(x), fixed(y)};
}

/// Straight lines through the points.
inline ArrayStroke polyline(const std::vector<Point>& points)
{
    ArrayStroke stroke{points.front(), {}};
    for (std::size_t i = 1; i < points.size(); ++i)
        stroke.segments.push_back({.from = points[i - 1], .to = points[i]});
    return stroke;
}

}

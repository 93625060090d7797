#pragma once

#include "core/math/segment.hpp"

#include <concepts>
#include <cstdint>

namespace kfast {

/// A key drawing read once from front to back: its strokes, and in each stroke its segments. A copy goes on
/// reading from where the original stood.
template <class R>
concept DrawingReader = std::copyable<R> && requires(R reader, const R& drawing)
{
    /// Strokes of the whole drawing, however many have been begun.
    {
        drawing.strokes()
        } -> std::same_as<std::uint32_t>;
    /// Begins the next stroke and returns the number of its segments; 0 if it is a single point. There is one
    /// more stroke, and all segments of the one before have been read.
    {
        reader.next_stroke()
        } -> std::same_as<std::uint32_t>;
    /// The first point of the stroke that was begun last.
    {
        drawing.start()
        } -> std::same_as<Point>;
    /// The next segment of that stroke, which has one more; it begins where the one before ended.
    {
        reader.next_segment()
        } -> std::same_as<Segment>;
};

}

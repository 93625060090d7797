#pragma once

#include "core/math/flatten.hpp"

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// A key drawing read once from front to back: its strokes, and in each stroke its segments. A copy continues
/// from where the original was.
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

/// A stroke in the caller's own array, which must outlive the view and all that reads it. The stroke is
/// closed if it ends where it begins.
class StrokeView {
public:
    /// Straight lines through `points`. One point alone is a dot, none is no stroke at all.
    constexpr StrokeView(std::span<const Point> points) : points_{points} {}
    /// Lines and curves, each beginning where the one before ended. None is no stroke at all.
    constexpr StrokeView(std::span<const Segment> segments) : segments_{segments} {}
    /// A temporary array would not outlive the view.
    template <class T, std::size_t count>
    StrokeView(const std::array<T, count>&&) = delete;

    constexpr bool is_empty() const { return points_.empty() && segments_.empty(); }

    /// 0 for a dot.
    constexpr std::uint32_t segments() const
    {
        const std::size_t count = points_.empty() ? segments_.size() : points_.size() - 1;
        return static_cast<std::uint32_t>(count);
    }

    /// Only of a stroke that is not empty.
    constexpr Point start() const { return points_.empty() ? segments_[0].from : points_[0]; }

    /// `index` is less than segments().
    constexpr Segment segment(std::uint32_t index) const
    {
        if (points_.empty())
            return segments_[index];
        return {.from = points_[index], .to = points_[index + 1]};
    }

private:
    std::span<const Point> points_;
    std::span<const Segment> segments_;
};

/// Reads a key drawing from the caller's own array of strokes, which must outlive it; empty strokes are
/// passed over. Without strokes it is the empty drawing. Small enough to be passed by value.
class DrawingView {
public:
    constexpr DrawingView() = default;
    constexpr explicit DrawingView(std::span<const StrokeView> strokes) : unread_{strokes}
    {
        count_ = static_cast<std::uint32_t>(std::count_if(
            strokes.begin(), strokes.end(), [](const StrokeView& stroke) { return !stroke.is_empty(); }));
    }

    /// A temporary array would not outlive the view.
    template <std::size_t count>
    explicit DrawingView(const std::array<StrokeView, count>&&) = delete;

    constexpr std::uint32_t strokes() const { return count_; }

    constexpr std::uint32_t next_stroke()
    {
        while (unread_.front().is_empty())
            unread_ = unread_.subspan(1);
        stroke_ = &unread_.front();
        unread_ = unread_.subspan(1);
        segment_ = 0;
        return stroke_->segments();
    }

    constexpr Point start() const { return stroke_->start(); }
    constexpr Segment next_segment() { return stroke_->segment(segment_++); }

private:
    std::span<const StrokeView> unread_;
    std::uint32_t count_ = 0; ///< of the whole drawing, without empty strokes
    const StrokeView* stroke_ = nullptr;
    std::uint32_t segment_ = 0; ///< the next one
};

static_assert(DrawingReader<DrawingView>);

}

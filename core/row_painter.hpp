#pragma once

#include "core/opacity.hpp"
#include "core/pixel_row.hpp"
#include "core/run_list.hpp"
#include "core/traced_picture.hpp"
#include "core/work.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// Columns of a row that are painted, and where.
struct RowWindow {
    Run columns;
    std::byte* first = nullptr; ///< the pixel of columns.begin
    std::size_t bytes = 0;
};

/// Lays what one layer covers of a row over a few windows, stretch by stretch from left to right.
template <PixelFormat format>
class LayerPainter {
public:
    LayerPainter(std::span<const RowWindow> windows, int y, Colour colour)
        : window_{windows.data()}, last_{window_ + windows.size()}, ink_{Row::ink(colour)},
          opacity_{colour.opacity}, y_{y}
    {
    }

    /// The columns from `begin` up to `end`, with a coverage of 1 … 255.
    void operator()(int begin, int end, std::int32_t level)
    {
        while (window_ != last_ && window_->columns.end <= begin)
            ++window_;
        for (const RowWindow* at = window_; at != last_ && at->columns.begin < end; ++at)
            lay(*at, std::max<int>(begin, at->columns.begin), std::min<int>(end, at->columns.end),
                static_cast<std::uint32_t>(level));
    }

private:
    using Row = PixelRow<format>;

    void lay(const RowWindow& window, int begin, int end, std::uint32_t level) const
    {
        Row row{window.first, window.columns.begin, y_};
        const std::uint32_t coverage = opacity_ == 255 ? level : product_of_opacities(level, opacity_);
        if (coverage == 255) {
            did(Work::fill);
            did(Work::filled_pixel, static_cast<std::uint32_t>(end - begin));
            row.fill(begin, end - begin, ink_);
        } else if (coverage != 0) {
            did(Work::blended_pixel, static_cast<std::uint32_t>(end - begin));
            row.blend(begin, end - begin, ink_, coverage);
        }
    }

    const RowWindow* window_; ///< the first one that ends behind what was laid
    const RowWindow* last_;
    std::uint32_t ink_;
    std::uint32_t opacity_;
    int y_;
};

/// Paints one row of a picture in a few windows, from left to right, that do not overlap.
template <PixelFormat format>
class RowPainter {
public:
    /// `backdrops` has room for a whole row for each depth of blending.
    RowPainter(std::span<const RowWindow> windows, int y, std::span<std::byte> backdrops,
               std::size_t whole_row)
        : windows_{windows}, y_{y}, backdrops_{backdrops}, whole_row_{whole_row}
    {
    }

    /// All steps from `first` on, and the background first if that is 0: what lies below is hidden.
    /// for_each_span(step, painter) calls painter(begin, end, level) for what the layer of `step`, a number,
    /// covers, from left to right.
    template <class ForEachSpan>
    void paint(const TracedPicture& picture, std::size_t first, Colour background, ForEachSpan for_each_span)
    {
        did(Work::step_visit, static_cast<std::uint32_t>(picture.step_count - first));
        if (first == 0)
            for (const RowWindow& window : windows_)
                fill(window, Row::ink(background));
        for (std::size_t i = first; i < picture.step_count; ++i) {
            const PaintStep& step = picture.steps()[i];
            if (step.kind == PaintStep::Kind::layer) {
                if (step.layer.reaches(y_))
                    paint_layer(step, i, for_each_span);
            } else if (step.kind == PaintStep::Kind::end_blend) {
                work_for(step.item);
                end_blend(step.opacity);
            } else {
                if (depth_ == 0) {
                    const std::size_t end = end_of_blend(picture, i);
                    if (!reach(picture.steps().subspan(i, end - i))) {
                        i = end;
                        continue;
                    }
                }
                work_for(step.item);
                begin_blend();
            }
        }
        work_for(0);
    }

private:
    using Row = PixelRow<format>;

    template <class ForEachSpan>
    void paint_layer(const PaintStep& step, std::size_t number, ForEachSpan& for_each_span)
    {
        work_for(step.item);
        LayerPainter<format> painter{windows_, y_, step.layer.colour};
        for_each_span(number, painter);
    }

    Row row(const RowWindow& window) const { return {window.first, window.columns.begin, y_}; }

    void fill(const RowWindow& window, std::uint32_t ink)
    {
        did(Work::fill);
        did(Work::filled_pixel, static_cast<std::uint32_t>(window.columns.width()));
        row(window).fill(window.columns.begin, window.columns.width(), ink);
    }

    /// The step that ends what the step `begin` begins.
    static std::size_t end_of_blend(const TracedPicture& picture, std::size_t begin)
    {
        int depth = 0;
        std::size_t i = begin;
        for (; i + 1 < picture.step_count; ++i) {
            const PaintStep::Kind kind = picture.steps()[i].kind;
            depth += kind == PaintStep::Kind::begin_blend ? 1 : kind == PaintStep::Kind::end_blend ? -1 : 0;
            if (depth == 0)
                break;
        }
        return i;
    }

    /// Whether one of the layers has something in this row.
    bool reach(std::span<const PaintStep> steps) const
    {
        return std::ranges::any_of(steps, [this](const PaintStep& step) {
            return step.kind == PaintStep::Kind::layer && step.layer.reaches(y_);
        });
    }

    void begin_blend()
    {
        std::byte* at = backdrop(depth_++);
        for (const RowWindow& window : windows_)
            at = std::copy_n(window.first, window.bytes, at);
    }

    void end_blend(std::uint32_t opacity)
    {
        const std::byte* at = backdrop(--depth_);
        for (const RowWindow& window : windows_) {
            did(Work::faded_pixel, static_cast<std::uint32_t>(window.columns.width()));
            row(window).fade_from(at, window.columns.begin, window.columns.width(), opacity);
            at += window.bytes;
        }
    }

    std::byte* backdrop(std::size_t depth) { return backdrops_.data() + depth * whole_row_; }

    std::span<const RowWindow> windows_;
    int y_;
    std::span<std::byte> backdrops_;
    std::size_t whole_row_;
    std::size_t depth_ = 0;
};

}

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
    /// for_each_span(step, paint) calls paint(begin, end, level) for what the layer of `step`, a number,
    /// covers, from left to right.
    template <class ForEachSpan>
    void paint(const TracedPicture& picture, std::size_t first, Colour background, ForEachSpan for_each_span)
    {
        did(Work::step_visit, static_cast<std::uint32_t>(picture.step_count - first));
        if (first == 0)
            for (const RowWindow& window : windows_)
                fill(window, window.columns.begin, window.columns.width(), Row::ink(background));
        for (std::size_t i = first; i < picture.step_count; ++i) {
            const PaintStep& step = picture.steps()[i];
            if (step.kind == PaintStep::Kind::begin_blend && depth_ == 0) {
                const std::size_t end = end_of_blend(picture, i);
                if (!reach(picture.steps().subspan(i, end - i))) {
                    i = end;
                    continue;
                }
            }
            work_for(step.item);
            if (step.kind == PaintStep::Kind::layer)
                paint_layer(step.layer, y_, [&](auto paint) { for_each_span(i, paint); });
            else if (step.kind == PaintStep::Kind::begin_blend)
                begin_blend();
            else
                end_blend(step.opacity);
        }
        work_for(0);
    }

private:
    using Row = PixelRow<format>;

    Row row(const RowWindow& window) const { return {window.first, window.columns.begin, y_}; }

    void fill(const RowWindow& window, int x, int count, std::uint32_t ink)
    {
        did(Work::fill);
        did(Work::filled_pixel, static_cast<std::uint32_t>(count));
        row(window).fill(x, count, ink);
    }

    void blend(const RowWindow& window, int x, int count, std::uint32_t ink, std::uint32_t coverage)
    {
        did(Work::blended_pixel, static_cast<std::uint32_t>(count));
        row(window).blend(x, count, ink, coverage);
    }

    template <class ForEachSpan>
    void paint_layer(const Layer& layer, int y, ForEachSpan for_each_span)
    {
        if (!layer.reaches(y))
            return;
        const std::uint32_t ink = Row::ink(layer.colour);
        const std::uint32_t opacity = layer.colour.opacity;
        auto window = windows_.begin();
        for_each_span([&](int begin, int end, std::int32_t level) {
            while (window != windows_.end() && window->columns.end <= begin)
                ++window;
            const std::uint32_t coverage = product_of_opacities(static_cast<std::uint32_t>(level), opacity);
            for (auto at = window; at != windows_.end() && at->columns.begin < end; ++at)
                lay(*at, begin, end, ink, coverage);
        });
    }

    void lay(const RowWindow& window, int begin, int end, std::uint32_t ink, std::uint32_t coverage)
    {
        begin = std::max<int>(begin, window.columns.begin);
        end = std::min<int>(end, window.columns.end);
        if (coverage == 255)
            fill(window, begin, end - begin, ink);
        else if (coverage != 0)
            blend(window, begin, end - begin, ink, coverage);
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

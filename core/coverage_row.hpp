#pragma once

#include "core/fixed.hpp"
#include "core/run_list.hpp"
#include "core/work.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace kfast {

/// How much of each pixel of one row is covered, from exact areas.
///
/// A cell holds by how much the coverage changes from the pixel before it, so that only pixels with an edge
/// in them are written. An edge covers everything to its right: a left edge adds, a right edge takes away.
class CoverageRow {
public:
    /// Cells that a row of `width` pixels needs.
    static constexpr std::size_t cells_for(int width) { return static_cast<std::size_t>(width) + 2; }

    /// `cells` holds zeros. They are zeros again after take_spans().
    CoverageRow(std::span<std::int32_t> cells, int width) : cells_{cells.data()}, width_{width} {}

    /// An edge that runs from x = `top` to x = `bottom` over `height` sub-rows; `sign` is 1 for a left edge
    /// and -1 for a right one, 0 for one that counts for nothing. x is rounded to 1/1024 px, the area is
    /// exact.
    void add(Fixed top, Fixed bottom, std::int32_t height, std::int32_t sign);

    /// Tells that edges will be added between x = `left` and x = `right`. That is done once for all of them,
    /// from left to right.
    void touch(Fixed left, Fixed right);
    /// As add(); the sign is not 0.
    void add_touched(Fixed top, Fixed bottom, std::int32_t height, std::int32_t sign);

    /// Calls paint(x, end, level) from left to right for every stretch of pixels with the same level of
    /// 1 … 255, and clears the row. 255 is covered wholly.
    template <class Paint>
    void take_spans(Paint&& paint);

private:
    static constexpr int area_bits = 21; ///< a pixel's area is 1024 sub-rows x 1024 sub-columns x 2

    static constexpr std::int32_t level_of(std::int32_t area)
    {
        return (area * 255 + (1 << (area_bits - 1))) >> area_bits;
    }

    static std::int32_t to_column(Fixed x) { return (x.raw() + 32) >> 6; }

    void add_clipped(std::int32_t left, std::int32_t right, std::int32_t height, std::int32_t sign);
    void add_across(std::int32_t left, std::int32_t right, std::int32_t height, std::int32_t sign);
    void deposit(std::int32_t cell, std::int32_t height, std::int32_t ends);

    std::int32_t* cells_;
    int width_;
    RunList touched_; ///< cells that were written
};

template <class Paint>
void CoverageRow::take_spans(Paint&& paint)
{
    std::int32_t area = 0;
    std::int32_t level = 0;
    int begin = 0; // of the stretch at `level`
    const auto change_at = [&](int x, std::int32_t to) {
        if (to == level)
            return;
        if (level != 0) {
            did(Work::span);
            paint(begin, x, level);
        }
        begin = x;
        level = to;
    };
    for (const Run& run : touched_.runs()) {
        did(Work::cell, static_cast<std::uint32_t>(run.width()));
        const int end = std::min<int>(run.end, width_);
        for (int x = run.begin; x < end; ++x) {
            area += std::exchange(cells_[x], 0);
            change_at(x, level_of(area));
        }
    }
    change_at(width_, 0);
    cells_[width_] = cells_[width_ + 1] = 0;
    touched_.clear();
}

}

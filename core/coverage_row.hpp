#pragma once

#include "core/fixed.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

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
    CoverageRow(std::span<std::int32_t> cells, int width) : cells_{cells}, width_{width} {}

    /// An edge that runs from x = `top` to x = `bottom` over `height` sub-rows; `sign` is 1 for a left edge
    /// and -1 for a right one. x is rounded to 1/1024 px, the area is exact.
    void add(Fixed top, Fixed bottom, std::int32_t height, std::int32_t sign);

    /// Calls paint(x, count, level) from left to right for every stretch of pixels with the same level of
    /// 1 … 255, and clears the row. 255 is covered wholly.
    template <class Paint>
    void take_spans(Paint paint);

private:
    static constexpr int area_bits = 21; ///< a pixel's area is 1024 sub-rows x 1024 sub-columns x 2

    void add_within(std::int32_t left, std::int32_t right, std::int32_t height, std::int32_t sign);
    void add_across(std::int32_t left, std::int32_t right, std::int32_t height, std::int32_t sign);
    void deposit(std::int32_t cell, std::int32_t height, std::int32_t ends);

    std::span<std::int32_t> cells_;
    int width_;
    int first_ = 0; ///< the cells that were written are first_ … last_
    int last_ = -1;
};

template <class Paint>
void CoverageRow::take_spans(Paint paint)
{
    std::int32_t area = 0;
    for (int x = first_; x <= last_ && x < width_;) {
        int end = x;
        area += cells_[static_cast<std::size_t>(end++)];
        while (end <= last_ && end < width_ && cells_[static_cast<std::size_t>(end)] == 0)
            ++end;
        if (end > last_ && area != 0)
            end = width_;
        const std::int32_t level = (area * 255 + (1 << (area_bits - 1))) >> area_bits;
        if (level != 0)
            paint(x, end - x, level);
        x = end;
    }
    if (first_ <= last_)
        std::fill(cells_.begin() + first_, cells_.begin() + last_ + 1, 0);
    first_ = width_ + 1;
    last_ = -1;
}

}

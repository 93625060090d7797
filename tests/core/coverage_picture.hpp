#pragma once

#include "core/sweep.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace kfast::test {

/// A picture of coverages 0 … 255, drawn from one layer of outlines.
class CoveragePicture {
public:
    CoveragePicture(int width, int height)
        : width_{width}, height_{height}, storage_(1 << 20), store_{storage_, height},
          levels_(static_cast<std::size_t>(width * height))
    {
    }

    OutlineStore& store() { return store_; }

    /// Sweeps the outlines that were added, from the top down.
    void draw(FillRule rule = FillRule::nonzero)
    {
        std::vector<int> rows(static_cast<std::size_t>(height_));
        std::iota(rows.begin(), rows.end(), 0);
        draw_rows(rows, rule);
    }

    /// The rows in any order.
    void draw_rows(const std::vector<int>& rows, FillRule rule = FillRule::nonzero)
    {
        std::vector<std::int32_t> cells(CoverageRow::cells_for(width_));
        CoverageRow coverage{cells, width_};
        Layer layer = layer_of(store_, store_.range_from({}));
        layer.rule = rule;
        std::fill(levels_.begin(), levels_.end(), 0);
        for (const int row : rows) {
            sweep_row(store_, layer, row, coverage);
            coverage.take_spans([&](int x, int end, std::int32_t level) {
                for (; x < end; ++x)
                    levels_.at(static_cast<std::size_t>(row * width_ + x)) = level;
            });
        }
    }

    int at(int x, int y) const { return levels_.at(static_cast<std::size_t>(y * width_ + x)); }
    const std::vector<int>& levels() const { return levels_; }
    int width() const { return width_; }
    int height() const { return height_; }

private:
    int width_;
    int height_;
    std::vector<std::byte> storage_;
    OutlineStore store_;
    std::vector<int> levels_;
};

}

#pragma once

#include "core/edge_list.hpp"
#include "core/sweep.hpp"

#include <vector>

namespace kfast::test {

/// A picture of coverages 0 … 255, drawn from one layer of edges.
class CoveragePicture {
public:
    CoveragePicture(int width, int height)
        : width_{width}, height_{height}, storage_(65534), edges_{storage_, height},
          levels_(static_cast<std::size_t>(width * height))
    {
    }

    EdgeList& edges() { return edges_; }
    Layer& layer() { return layer_; }

    /// Sweeps the edges that were added.
    void draw()
    {
        std::vector<std::int32_t> cells(CoverageRow::cells_for(width_));
        CoverageRow coverage{cells, width_};
        edges_.sort(layer_);
        for (int row = 0; row < height_; ++row) {
            sweep_row(edges_, layer_, row, coverage);
            coverage.take_spans([&](int x, int count, std::int32_t level) {
                for (int i = 0; i < count; ++i)
                    levels_.at(static_cast<std::size_t>(row * width_ + x + i)) = level;
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
    std::vector<Edge> storage_;
    EdgeList edges_;
    Layer layer_;
    std::vector<int> levels_;
};

}

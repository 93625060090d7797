#pragma once

#include "core/raster/layer_row.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace kfast::test {

/// How the coverage of a layer is found: all ways yield the same.
struct WayToDraw {
    int band_bits = 2;
    int columns = raster::tile_columns; ///< of a tile
    bool by_edges = false;              ///< where these tell the coverage
};

/// A picture of coverages 0 … 256, drawn from one layer of outlines.
class CoveragePicture {
public:
    CoveragePicture(int width, int height)
        : size_{width, height},
          memory_(1 << 18),
          heads_(static_cast<std::size_t>(height)),
          store_{std::as_writable_bytes(std::span{memory_}), heads_, size_, WayToDraw{}.band_bits},
          levels_(static_cast<std::size_t>(width * height))
    {
        store_.begin_layer({}, 0);
    }

    raster::OutlineStore& store() { return store_; }

    /// The outlines that were added.
    void draw(FillRule rule = FillRule::nonzero, const WayToDraw& way = {})
    {
        std::ranges::fill(levels_, 0);
        store_.rewind(way.band_bits);
        const std::vector<raster::PaintStep> steps(1);
        raster::Band band;
        band.begin(store_, steps, size_);
        do {
            band.advance();
            for (int left = 0; left < size_.width; left += way.columns)
                draw_tile(band, rule, left, std::min(way.columns, size_.width - left), way.by_edges);
        } while (band.top_row() + band.row_count() != size_.height);
    }

    int at(int x, int y) const { return levels_.at(static_cast<std::size_t>(y * size_.width + x)); }
    const std::vector<int>& levels() const { return levels_; }
    int width() const { return size_.width; }
    int height() const { return size_.height; }

private:
    void draw_tile(const raster::Band& band, FillRule rule, int left, int columns, bool by_edges)
    {
        const raster::Region all{.end = static_cast<std::int16_t>(size_.width), .first = band.first()};
        raster::LayerRow layer{sums_};
        if (!layer.begin(band, all, 0, rule, left, columns))
            return;
        for (int row = 0; row != band.row_count(); ++row) {
            int* const out = levels_.data() + (band.top_row() + row) * size_.width + left;
            if (by_edges && layer.find_edges(row))
                draw_edges(layer, out, columns);
            else
                layer.sum_up(row, [&](int begin, int end, int coverage) {
                    std::fill(out + begin, out + end, coverage);
                });
        }
    }

    void draw_edges(raster::LayerRow& layer, int* out, int columns)
    {
        bool is_inside = layer.is_inside_at_left();
        int column = 0;
        for (std::size_t i = 0; i != layer.edge_count(); ++i) {
            raster::CoverageRun run;
            layer.cover_edge(i, is_inside, run);
            std::fill(out + column, out + run.begin, is_inside ? raster::full_coverage : 0);
            for (column = run.begin; column != run.end; ++column) {
                const int right = run.pixels[static_cast<std::size_t>(column - run.begin)];
                out[column] = is_inside ? raster::full_coverage - right : right;
            }
            is_inside = !is_inside;
        }
        std::fill(out + column, out + columns, is_inside ? raster::full_coverage : 0);
    }

    Size size_;
    std::vector<std::uint32_t> memory_;
    std::vector<std::uint32_t> heads_;
    raster::OutlineStore store_;
    raster::CoverageSums sums_;
    std::vector<int> levels_;
};

}

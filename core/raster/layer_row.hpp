#pragma once

#include "core/raster/band.hpp"
#include "core/raster/coverage.hpp"
#include "core/raster/dirty.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace kfast::raster {

/// What one layer covers of a part of a band, row by row: by its edges where these are apart, by sums of
/// areas where they share a pixel, begin, end or bend.
///
/// Where outlines of a layer overlap within a pixel, their areas add up to one pixel at most.
class LayerRow {
public:
    /// The chains of a layer that lie in a region; columns are counted from `left` from now on, and end at
    /// `columns`. False if there are none.
    bool begin(const Band& band, const Region& region, std::uint16_t layer, FillRule rule, int left,
               int columns);
    bool is_inside_at_left() const { return is_inside(winding_); }

    /// Finds the edges of a row of the band between what is inside and what is outside. False if they do not
    /// tell the coverage: then sum_up() does.
    bool find_edges(int row);
    std::size_t edge_count() const { return edge_count_; }
    const RowEdge& edge(std::size_t number) const { return edges_[number]; }

    /// Calls span(begin, end, coverage) for all columns of a row, from left to right.
    template <class Span>
    void sum_up(int row, Span span)
    {
        add_row(row);
        std::int32_t sum = winding_ * (CoverageSums::full >> band_->height_bits());
        for (int column = 0; column != columns_;) {
            const int begin = column;
            sum += sums_.take(column);
            column = sums_.next(column + 1, columns_);
            span(begin, column, coverage_of(sum));
        }
    }

private:
    static constexpr std::size_t max_edges = 8;

    bool is_inside(std::int32_t winding) const;
    std::int32_t coverage_of(std::int32_t sum) const;
    void add_row(int row);
    void add_parts(const Chain& chain, int row);
    RowEdge edge_of(const Chain& chain, int row) const;

    const Band* band_ = nullptr;
    std::uint32_t first_ = Chain::none; ///< chain of the region
    std::uint32_t behind_ = Chain::none;
    std::uint16_t layer_ = 0;
    FillRule rule_ = FillRule::nonzero;
    int left_ = 0;
    int columns_ = 0;
    std::int32_t winding_ = 0; ///< to the left of all chains, in the unit of Chain::winding
    bool has_few_ = false;     ///< chains: they are in the list
    std::size_t chain_count_ = 0;
    std::size_t edge_count_ = 0;
    std::array<const Chain*, max_edges> chains_;
    std::array<RowEdge, max_edges> edges_;
    CoverageSums sums_;
};

}

#pragma once

#include "core/bytes/function_ref.hpp"
#include "core/raster/band.hpp"
#include "core/raster/coverage.hpp"
#include "core/raster/dirty.hpp"
#include "core/raster/edge_group.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast::raster {

/// What one layer covers of a part of a band, row by row: by its edges where these are apart, by sums of
/// areas where they share a pixel, begin or end.
class LayerRow {
public:
    /// `sums` are empty, and so they are between rows.
    explicit LayerRow(CoverageSums& sums) : sums_{sums} {}
    LayerRow(const LayerRow&) = delete;

    /// Takes the chains of a layer in a region; columns are counted from `left` from now on, and end at
    /// `columns`. Returns false if there are none.
    bool begin(const Band& band, const Region& region, std::uint16_t layer, FillRule rule, int left,
               int columns);
    bool is_inside_at_left() const { return kfast::is_inside(rule_, winding_ >> band_->height_bits()); }

    /// Finds the edges of a row of the band between what is inside and what is outside. Returns false if they
    /// do not give the coverage: then sum_up() does.
    bool find_edges(int row);
    std::size_t edge_count() const { return edge_count_; }
    /// How much of the pixels that such an edge touches is to the right of it; the layer is inside on its
    /// left side or on its right one.
    [[gnu::noinline]] void cover_edge(std::size_t number, bool is_inside_left, CoverageRun& run);

    /// Calls span(begin, end, coverage) for all columns of a row, from left to right.
    template <class Span>
    void sum_up(int row, Span span)
    {
        add_row(row);
        sums_.sum_up(columns_, winding_ * (CoverageSums::full >> band_->height_bits()),
                     [&](int begin, int end, std::int32_t sum) { span(begin, end, coverage_of(sum)); });
    }

private:
    static constexpr std::size_t max_edges = 8;
    static constexpr int no_pixel = 1 << 20; ///< further to the right than any

    struct ListedChain {
        const Chain* chain;
        const Crossing* x;  ///< at the borders of the rows of the band
        std::int32_t start; ///< what these count from, at the left border of the tile

        /// The edge in a row that it goes through without bends.
        [[gnu::always_inline]] RowEdge edge(int row) const
        {
            return edge_between(x[row] - start, x[row + 1] - start);
        }
    };

    /// Chains of the band that follow each other.
    struct Cluster {
        std::uint32_t first = Chain::none;
        std::uint32_t behind = Chain::none;
    };

    bool find_chains(const Region& region);
    void begin_list(std::uint32_t first, std::int32_t winding);
    void find_borders();
    std::int32_t coverage_of(std::int32_t sum) const;
    void add_row(int row);
    void add_few(int row);
    void add_many(int row);
    void each_left_chain(int row, FunctionRef<void(const RowChain&)> visit) const;
    std::int32_t add_left_of_panel(int row);
    void each_chain(const Cluster& cluster, int row, FunctionRef<bool(const RowChain&, int)> visit) const;
    void sort_last(std::size_t count);
    std::int32_t add_groups(std::size_t& count, int limit, std::int32_t winding);
    std::int32_t add_cluster(const Cluster& cluster, int row, std::int32_t winding);
    [[gnu::cold, gnu::noinline]] std::int32_t add_crowd(const Cluster& cluster, int row, int begin,
                                                        std::int32_t winding);
    /// Calls the function that it is given for each chain of a group.
    using EachChain = FunctionRef<void(FunctionRef<void(const RowChain&)>)>;
    [[gnu::cold, gnu::noinline]] std::int32_t add_large_group(EachChain each_chain, std::int32_t winding);
    int end_of_group(const Cluster& cluster, int row, int begin) const;
    bool find_row_chain(const Chain& chain, int row, RowChain& found) const;
    void set_row_chain(const Chain& chain, int row, bool is_straight, RowChain& found) const;

    const Band* band_ = nullptr;
    std::uint32_t first_ = Chain::none; ///< chain of the first cluster that reaches the tile
    std::uint32_t behind_ = Chain::none;
    std::uint16_t layer_ = 0;
    FillRule rule_ = FillRule::nonzero;
    int left_ = 0;
    int columns_ = 0;
    int begin_ = 0;            ///< pixels of chains to the left of it do not matter in the row
    std::int32_t winding_ = 0; ///< to the left of all chains, in the unit of Chain::winding
    bool has_few_ = false;     ///< the chains are few: they are in the list
    bool are_apart_ = false;   ///< all chains go through the band without touching the same column
    std::size_t chain_count_ = 0;
    std::size_t edge_count_ = 0;
    int row_ = 0; ///< the row that find_edges() was called for, if they are apart
    std::array<ListedChain, max_edges> chains_;
    std::array<const ListedChain*, max_edges> borders_; ///< if they are apart: those that are edges
    std::array<RowEdge, max_edges> edges_;              ///< if they are not
    std::array<const RowChain*, max_edges>
        bent_; ///< in place of an edge: the chain that bends; null if it does not
    std::array<RowChain, max_group> group_;
    CoverageSums& sums_;
};

}

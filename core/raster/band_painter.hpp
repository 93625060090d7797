#pragma once

#include "core/bytes/op_counter.hpp"
#include "core/raster/band.hpp"
#include "core/raster/cells.hpp"
#include "core/raster/dirty.hpp"
#include "core/raster/layer_row.hpp"
#include "core/raster/outline/paint_step.hpp"
#include "core/raster/slots.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast::raster {

/// Paints regions of a band.
///
/// What a pixel becomes depends on the picture alone: every method paints the same layers over each other
/// from the lowest upwards, with the same coverages. Most regions have one edge between two colours, for
/// which there is a method of its own.
template <class Cells>
class BandPainter {
public:
    using Cell = typename Cells::Cell;

    /// `backdrops` has room for a tile for each depth of groups.
    BandPainter(const Band& band, std::span<const PaintStep> steps, const Slots& slots, LayerRow& row,
                std::span<Cell> backdrops)
        : band_{band}, steps_{steps}, slots_{slots}, row_{row}, backdrops_{backdrops}
    {
    }

    /// Paints the part of the region that is within the columns of the tile.
    void paint(const Region& region, const Tile<Cells>& tile)
    {
        count_op(Op::region);
        if (!region.has_slots)
            return paint_steps(region, tile);
        const SlotMask crossing = layers_in(region);
        if (((region.inside | crossing) & slots_.grouped) != 0)
            return paint_steps(region, tile);
        if (crossing == 0)
            return fill_all(tile, Cells::cell(flat(region.inside)));
        if (!paint_single_edge(region, crossing, tile))
            paint_layers(region, crossing, tile);
    }

private:
    SlotMask layers_in(const Region& region) const
    {
        SlotMask layers = 0;
        for (std::uint32_t place = region.first; place != region.behind; place = band_.chain(place).next) {
            count_op(Op::chain_visit);
            layers |= bit_of(band_.chain(place).slot);
        }
        return layers;
    }

    /// The ink where these layers cover everything. None is in a group.
    std::uint32_t flat(SlotMask layers) const
    {
        const SlotMask top = top_bit(layers);
        if (top == 0)
            return slots_.background_ink;
        const Slots::Layer& layer = slots_.layer(number_of(top));
        if ((top & slots_.clear) == 0)
            return layer.ink;
        return Cells::mixed(flat(layers & ~top), layer.ink, layer.share);
    }

    static void fill_all(const Tile<Cells>& tile, Cell cell)
    {
        Cell* at = tile.cells;
        for (int row = 0; row != tile.rows; ++row, at += tile.stride)
            fill(at, tile.columns, cell);
    }

    /// Returns false if the region has anything else.
    bool paint_single_edge(const Region& region, SlotMask crossing, const Tile<Cells>& tile) const
    {
        const Chain& chain = band_.chain(region.first);
        if (chain.next != region.behind || !chain.is_whole || !chain.is_border ||
            (region.inside & (crossing - 1)) != 0 || (crossing & slots_.clear) != 0)
            return false;
        const std::uint32_t below = flat(region.inside & ~crossing);
        const std::uint32_t ink = slots_.layer(chain.slot).ink;
        const bool is_inside = (region.inside & crossing) != 0;
        const Cell left = Cells::cell(is_inside ? ink : below);
        const Cell right = Cells::cell(is_inside ? below : ink);
        count_ops_for(slots_.layer(chain.slot).next->item);
        const std::int32_t start = (tile.left - chain.left) * grid;
        const Crossing* x = band_.crossings(chain, tile.first_row);
        Cell* at = tile.cells;
        CoverageRun run;
        for (int row = 0; row != tile.rows; ++row, ++x, at += tile.stride) {
            if (row != 0 && x[0] == x[1] && x[0] == x[-1]) { // as the row above
                repeat(at - tile.stride, tile.columns, at);
                count_op(Op::filled_pixel, static_cast<std::uint32_t>(tile.columns));
                continue;
            }
            count_op(Op::edge_row);
            cover(edge_between(x[0] - start, x[1] - start), tile.columns, run);
            count_op(Op::filled_pixel, static_cast<std::uint32_t>(tile.columns - (run.end - run.begin)));
            Cell* cell = at;
            for (const Cell* const end = at + run.begin; cell != end; ++cell)
                *cell = left;
            const std::uint16_t* coverage = run.pixels.data();
            for (const Cell* const end = at + run.end; cell != end; ++cell)
                *cell = Cells::cell(
                    Cells::mixed(below, ink, Cells::share(inside_coverage(*coverage++, is_inside))));
            for (const Cell* const end = at + tile.columns; cell != end; ++cell)
                *cell = right;
        }
        return true;
    }

    static void repeat(const Cell* from, int count, Cell* to)
    {
        for (const Cell* const end = from + count; from != end; ++from, ++to)
            *to = *from;
    }

    /// The coverage of a pixel that an edge crosses, `right` of it to the right of the edge; the layer is
    /// inside on the left side of the edge or on its right one.
    static std::int32_t inside_coverage(std::int32_t right, bool is_inside_left)
    {
        return is_inside_left ? full_coverage - right : right;
    }

    /// Starts with the topmost opaque layer that covers all of the region.
    void paint_layers(const Region& region, SlotMask crossing, const Tile<Cells>& tile)
    {
        const SlotMask solid = top_bit(region.inside & ~crossing & ~slots_.clear);
        fill_all(tile, Cells::cell(flat(solid)));
        SlotMask rest = (region.inside | crossing) & (solid - 1);
        for (unsigned slot = slot_count - 1; rest != 0; --slot) {
            const SlotMask bit = bit_of(slot);
            if ((rest & bit) == 0)
                continue;
            rest &= ~bit;
            const Slots::Layer& layer = slots_.layer(slot);
            paint_layer(region, *layer.next, {layer.ink, layer.share}, tile);
        }
    }

    /// How a layer is blended over what is below it.
    struct Coat {
        std::uint32_t ink;
        std::uint32_t opacity; ///< a fraction, as Cells::share()

        std::uint32_t share_of(std::int32_t coverage) const
        {
            const std::uint32_t share = Cells::share(coverage);
            return opacity == Cells::full_share ? share : product_of_shares<Cells>(share, opacity);
        }
    };

    void paint_layer(const Region& region, const PaintStep& step, const Coat& coat, const Tile<Cells>& tile)
    {
        count_ops_for(step.item);
        count_op(Op::layer);
        const auto number = static_cast<std::uint16_t>(&step - steps_.data());
        const bool has_edges = row_.begin(band_, region, number, step.rule, tile.left, tile.columns);
        count_op(Op::layer_row, static_cast<std::uint32_t>(tile.rows));
        const bool is_inside = has_edges && row_.is_inside_at_left();
        Cell* at = tile.cells;
        for (int row = 0; row != tile.rows; ++row, at += tile.stride) {
            if (!has_edges)
                lay(at, at + tile.columns, coat.ink, coat.opacity);
            else if (row_.find_edges(tile.first_row + row))
                lay_between_edges(at, tile.columns, coat, is_inside);
            else
                row_.sum_up(tile.first_row + row, [at, &coat](int begin, int end, std::int32_t coverage) {
                    count_op(Op::span);
                    if (coverage != 0)
                        lay(at + begin, at + end, coat.ink, coat.share_of(coverage));
                });
        }
    }

    void lay_between_edges(Cell* at, int columns, const Coat& coat, bool is_inside) const
    {
        Cell* cell = at;
        CoverageRun run;
        for (std::size_t number = 0; number != row_.edge_count(); ++number) {
            row_.cover_edge(number, is_inside, run);
            if (is_inside)
                lay(cell, at + run.begin, coat.ink, coat.opacity);
            lay_edge(at, run, coat, is_inside);
            cell = at + run.end;
            is_inside = !is_inside;
        }
        if (is_inside)
            lay(cell, at + columns, coat.ink, coat.opacity);
    }

    [[gnu::noinline]] static void lay_edge(Cell* at, const CoverageRun& run, const Coat coat, bool is_inside)
    {
        count_op(Op::blended_pixel, static_cast<std::uint32_t>(run.end - run.begin));
        const std::uint16_t* coverage = run.pixels.data();
        const Cell* const end = at + run.end;
        for (Cell* cell = at + run.begin; cell != end; ++cell)
            *cell = Cells::cell(Cells::mixed(Cells::ink_of(*cell), coat.ink,
                                             coat.share_of(inside_coverage(*coverage++, is_inside))));
    }

    [[gnu::noinline]] static void lay(Cell* cell, Cell* end, std::uint32_t ink, std::uint32_t share)
    {
        if (share == Cells::full_share)
            return fill(cell, static_cast<int>(end - cell), Cells::cell(ink));
        if (share == 0)
            return;
        count_op(Op::blended_pixel, static_cast<std::uint32_t>(end - cell));
        for (; cell != end; ++cell)
            *cell = Cells::cell(Cells::mixed(Cells::ink_of(*cell), ink, share));
    }

    /// Paints step by step, with groups.
    [[gnu::cold, gnu::noinline]] void paint_steps(const Region& region, const Tile<Cells>& tile)
    {
        fill_all(tile, Cells::cell(slots_.background_ink));
        std::size_t depth = 0;
        for (const PaintStep& step : steps_) {
            if (step.kind == PaintStep::Kind::begin_group)
                keep(tile, backdrop(depth++));
            else if (step.kind == PaintStep::Kind::end_group)
                fade(tile, backdrop(--depth), opacity_share<Cells>(step.opacity));
            else if (is_in(region, step))
                paint_layer(region, step,
                            {Cells::ink(step.colour), opacity_share<Cells>(step.colour.opacity)}, tile);
        }
    }

    bool is_in(const Region& region, const PaintStep& step) const
    {
        if (region.has_slots && step.slot != PaintStep::no_slot && (region.inside & bit_of(step.slot)) != 0)
            return true;
        const auto number = static_cast<std::uint16_t>(&step - steps_.data());
        for (std::uint32_t place = region.first; place != region.behind; place = band_.chain(place).next)
            if (band_.chain(place).layer == number)
                return true;
        return false;
    }

    static void keep(const Tile<Cells>& tile, Cell* to)
    {
        for (int row = 0; row != tile.rows; ++row)
            to = std::copy_n(tile.cells + row * tile.stride, tile.columns, to);
    }

    static void fade(const Tile<Cells>& tile, const Cell* before, std::uint32_t share)
    {
        count_op(Op::faded_pixel, static_cast<std::uint32_t>(tile.rows * tile.columns));
        for (int row = 0; row != tile.rows; ++row)
            for (Cell *cell = tile.cells + row * tile.stride, *const end = cell + tile.columns; cell != end;
                 ++cell, ++before)
                *cell = Cells::cell(Cells::mixed(Cells::ink_of(*before), Cells::ink_of(*cell), share));
    }

    Cell* backdrop(std::size_t depth) const
    {
        return backdrops_.data() + depth * (tile_bytes / sizeof(Cell));
    }

    const Band& band_;
    std::span<const PaintStep> steps_;
    const Slots& slots_;
    LayerRow& row_;
    std::span<Cell> backdrops_;
};

}

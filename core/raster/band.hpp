#pragma once

#include "core/bytes/expects.hpp"
#include "core/math/point.hpp"
#include "core/raster/outline/chain.hpp"
#include "core/raster/outline/outline_store.hpp"
#include "core/raster/outline/paint_step.hpp"
#include "core/raster/slots.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast::raster {

/// The chains that reach into a band of rows, in a list from left to right by their first columns; bands
/// come from the top down.
class Band {
public:
    /// Goes before the first band of a picture; `store` and `steps` must outlive it. Chains to the right of
    /// the panel are left out.
    void begin(const OutlineStore& store, std::span<const PaintStep> steps, Size panel);
    /// Moves on to a band further down. Chains that come into the list have the slots of their layers.
    void advance(int number);
    /// Moves on to the next band.
    void advance() { advance(number_ + 1); }
    /// All chains have the slots of their layers, which may have changed.
    void take_slots();
    /// Finds the winding numbers, and what is a border; `even_odd` are the layers with this rule.
    void wind(SlotMask even_odd);

    int number() const { return number_; }
    /// In rows of the panel.
    int top_row() const { return number_ << store_->band_bits(); }
    int row_count() const;
    int panel_width() const { return panel_.width; }
    /// A band is 2^height_bits() high, in the grid.
    int height_bits() const { return grid_bits + store_->band_bits(); }

    /// Place of the first chain of the list; Chain::none at its end.
    std::uint32_t first() const { return first_; }
    Chain& chain(std::uint32_t place) const { return store_->chain(place); }
    /// x where the chain crosses the border above a row of the band, in the grid; then come the borders
    /// below. Only those within the chain mean anything.
    const Crossing* crossings(const Chain& chain, int row) const
    {
        return store_->crossing(chain.crossings) + row;
    }
    const Bend* bends(const Chain& chain) const { return store_->bend(chain.bends); }

private:
    [[gnu::noinline]] void take(std::uint32_t list, int bands_above);
    void move_on(Chain& chain, int bands);
    void find_columns(Chain& chain) const;
    void find_part(Chain& chain) const;
    void find_range(Chain& chain, int first, int last, std::int32_t bottom) const;
    void insert(std::uint32_t place);

    const OutlineStore* store_ = nullptr;
    std::uint32_t first_ = Chain::none;
    std::uint32_t inserted_ = Chain::none; ///< the last one that was
    std::uint32_t hidden_ = Chain::none;   ///< chains of the band to the right of the panel
    std::span<const PaintStep> steps_;
    Size panel_;
    int number_ = -1;
    std::int32_t top_ = 0;                            ///< of the band
    std::int32_t bottom_ = 0;                         ///< of the band
    std::array<std::int32_t, slot_count> windings_{}; ///< all 0 between bands
};

/// A set of bands, in memory that the caller lends.
class BandSet {
public:
    BandSet() = default;
    /// `words` has a bit for each band, at least.
    explicit BandSet(std::span<std::uint32_t> words) : words_{words} { clear(); }

    static constexpr std::size_t words_for(int bands) { return (static_cast<std::size_t>(bands) + 31) / 32; }

    void clear() { std::ranges::fill(words_, 0U); }
    /// From `begin` up to but not including `end`.
    void add(int begin, int end)
    {
        expects(begin >= 0 && end <= static_cast<int>(32 * words_.size()));
        for (int band = begin; band < end; ++band)
            word(band) |= bit(band);
    }
    bool has(int band) const { return (word(band) & bit(band)) != 0; }

private:
    std::uint32_t& word(int band) const { return words_[static_cast<unsigned>(band) / 32]; }
    static constexpr std::uint32_t bit(int band)
    {
        return std::uint32_t{1} << (static_cast<unsigned>(band) % 32);
    }

    std::span<std::uint32_t> words_;
};

}

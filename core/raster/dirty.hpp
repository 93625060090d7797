#pragma once

#include "core/bytes/expects.hpp"
#include "core/math/point.hpp"
#include "core/raster/band.hpp"
#include "core/raster/record.hpp"
#include "core/raster/slots.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast::raster {

/// An area of a panel and the pixels to be shown there, row by row; every row starts on a byte.
struct Change {
    Rect area;
    std::span<const std::byte> pixels;
};

/// Columns of a band that are drawn.
struct Region {
    std::int16_t begin = 0;
    std::int16_t end = 0;
    SlotMask inside = 0;                ///< layers that cover its left border
    std::uint32_t first = Chain::none;  ///< its first chain, in the list of the band
    std::uint32_t behind = Chain::none; ///< the first chain that is not in it any more
    RowMask rows = all_rows;            ///< those between the first and the last are drawn
    bool has_slots = true;              ///< whether its chains have slots; else `inside` is 0
};

/// Regions of a band from left to right.
class RegionList {
public:
    static constexpr std::size_t max_count = 24;

    const Region* begin() const { return regions_.data(); }
    const Region* end() const { return regions_.data() + count_; }
    bool is_empty() const { return count_ == 0; }

    void clear() { count_ = 0; }
    /// Sets one region with all of a band, if nothing is known of its layers.
    void set_whole(int columns, std::uint32_t first)
    {
        regions_[0] = {.end = static_cast<std::int16_t>(columns), .first = first, .has_slots = false};
        count_ = 1;
    }
    /// For filling the list: there is room for max_count of them, and end_at() sets their end.
    Region* data() { return regions_.data(); }
    void end_at(const Region* end)
    {
        count_ = static_cast<std::size_t>(end - regions_.data());
        expects(count_ <= max_count);
    }

private:
    std::array<Region, max_count> regions_;
    std::size_t count_ = 0;
};

/// Finds where a band differs from what the panel shows: `shown`, given by borders and by steps.
///
/// Chains of both pictures are visited from left to right. Those that overlap, directly or by others, are a
/// cluster: dirty if its layers have moved or look different. Between clusters all rows are alike, so that
/// the layers on either side determine whether a gap is dirty.
///
///     shown    |---|     |---|           |---|
///     coming     |---|   |---|                   |---|
///              dirty     clean    dirty  gap     dirty
void find_dirty(const Band& band, std::span<const Record::Border> shown,
                std::span<const PaintStep> shown_steps, const Slots& slots, int columns, RegionList& dirty);

/// All columns of a band, as if nothing were known of the panel.
void find_all(const Band& band, const Slots& slots, int columns, RegionList& regions);

/// The region of these columns, with all chains that are in one cluster with those in them.
[[gnu::cold, gnu::noinline]] Region region_between(const Band& band, int begin, int end);

}

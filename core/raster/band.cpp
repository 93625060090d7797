#include "core/raster/band.hpp"

#include "core/bytes/expects.hpp"
#include "core/bytes/op_counter.hpp"

#include <algorithm>
#include <utility>

namespace kfast::raster {

void Band::begin(const OutlineStore& store, std::span<const PaintStep> steps, Size panel)
{
    *this = {};
    store_ = &store;
    steps_ = steps;
    panel_ = panel;
}

int Band::row_count() const { return std::min(1 << store_->band_bits(), panel_.height - top_row()); }

void Band::advance(int number)
{
    expects(number > number_);
    count_op(Op::band);
    const int passed_bands = number - number_;
    const std::int32_t height = grid << store_->band_bits();
    top_ = number * height;
    bottom_ = top_ + height;
    const std::uint32_t shown = std::exchange(first_, Chain::none);
    const std::uint32_t hidden = std::exchange(hidden_, Chain::none);
    inserted_ = Chain::none;
    take(shown, passed_bands);
    take(hidden, passed_bands);
    for (int bands = passed_bands - 1; bands >= 0; --bands) {
        const std::uint32_t begun = store_->first_in(number - bands);
        for (std::uint32_t place = begun; place != Chain::none; place = chain(place).next)
            chain(place).slot = steps_[chain(place).layer].slot;
        take(begun, bands);
    }
    number_ = number;
    count_ops_for(0);
}

/// Links those chains of the list that reach the band; their state is that of `bands_above` above it.
void Band::take(std::uint32_t list, int bands_above)
{
    for (std::uint32_t next = Chain::none; list != Chain::none; list = next) {
        Chain& taken = chain(list);
        next = taken.next;
        if (bands_above != 0) {
            if (taken.bottom <= top_)
                continue;
            move_on(taken, bands_above);
        }
        insert(list);
    }
}

void Band::take_slots()
{
    for (std::uint32_t place = first_; place != Chain::none; place = chain(place).next)
        chain(place).slot = steps_[chain(place).layer].slot;
}

/// A part of the band's height counts as a part of a winding: pieces that end within the band add up to whole
/// ones.
void Band::wind(SlotMask even_odd)
{
    const std::int32_t whole = bottom_ - top_;
    for (std::uint32_t place = first_; place != Chain::none;) {
        Chain& chain = store_->chain(place);
        place = chain.next;
        std::int32_t& winding = windings_[chain.slot];
        chain.winding = winding;
        const std::int32_t right = winding + chain.height;
        chain.is_border = (winding == 0) != (right == 0);
        if ((even_odd & bit_of(chain.slot)) != 0)
            chain.is_border = (((winding + whole / 2) ^ (right + whole / 2)) & whole) != 0;
        winding = right;
    }
    if (hidden_ != Chain::none) // what closes the outlines is missing
        windings_.fill(0);
}

/// Moves the chain on from its state `bands` bands above.
void Band::move_on(Chain& chain, int bands)
{
    if (chain.is_straight)
        return;
    chain.crossings +=
        std::uint32_t{sizeof(Crossing)} * static_cast<std::uint32_t>(bands << store_->band_bits());
    const auto above = static_cast<std::uint32_t>(top_ - (chain.top & -grid));
    while (store_->bend(chain.bends)->y <= above)
        chain.bends -= std::uint32_t{sizeof(Bend)};
}

/// A chain reaches the pixels of all its corners and crossings, also where it only touches their left border.
/// So pieces of an outline that meet within the band overlap, and where no piece is, all rows of the band are
/// alike.
void Band::find_columns(Chain& chain) const
{
    if (chain.top > top_ || chain.bottom < bottom_)
        return find_part(chain);
    const std::int32_t height = bottom_ - top_;
    chain.is_whole = true;
    chain.rows = all_rows;
    chain.height = static_cast<std::int16_t>(chain.runs_down ? height : -height);
    find_range(chain, 0, floor_pixel(height), bottom_);
}

/// Finds the rows and the part of the height of a chain that begins or ends in the band.
void Band::find_part(Chain& chain) const
{
    const std::int32_t from = std::max(top_, chain.top);
    const std::int32_t to = std::min(bottom_, chain.bottom);
    const int first = floor_pixel(from - top_);
    const int last = ceil_pixel(to - top_);
    chain.is_whole = false;
    chain.rows =
        store_->band_bits() <= default_band_bits ? row_mask(first, std::max(last, first + 1)) : all_rows;
    const bool is_cut = chain.bottom == panel_.height * grid; // what is cut off would go on through the band
    const std::int32_t height = (is_cut ? bottom_ : to) - from;
    chain.height = static_cast<std::int16_t>(chain.runs_down ? height : -height);
    find_range(chain, first, last, to);
}

/// Finds the columns, from the crossings `first` to `last` and the bends down to `bottom`.
void Band::find_range(Chain& chain, int first, int last, std::int32_t bottom) const
{
    const Crossing* x = crossings(chain, first);
    std::int32_t low = *x;
    std::int32_t high = low;
    for (const Crossing* const end = x + (last - first); x != end;) {
        const std::int32_t at = *++x;
        low = at < low ? at : low;
        high = at > high ? at : high;
    }
    const auto end = static_cast<std::uint32_t>(bottom - (chain.top & -grid));
    for (const Bend* bend = bends(chain); bend->y <= end; --bend) {
        low = std::min<std::int32_t>(low, bend->x);
        high = std::max<std::int32_t>(high, bend->x);
        chain.is_whole = false;
    }
    chain.begin = static_cast<std::int16_t>(std::max(floor_pixel(low) + chain.left, 0));
    chain.end = static_cast<std::int16_t>(std::max(floor_pixel(high) + chain.left + 1, 1));
}

/// The place is mostly after the previous one: chains come in the order of the band above, or follow each
/// other along an outline.
void Band::insert(std::uint32_t place)
{
    Chain& added = chain(place);
    count_ops_for(steps_[added.layer].item);
    count_op(added.is_straight ? Op::straight_chain : Op::band_chain);
    if (added.is_straight) {
        StraightLine& line = store_->line(added);
        find_crossings(added, line, floor_pixel(top_), floor_pixel(bottom_ - top_), line.in_band.data());
    }
    find_columns(added);
    if (added.begin >= panel_.width) {
        added.next = std::exchange(hidden_, place);
        return;
    }
    std::uint32_t* link = &first_;
    if (inserted_ != Chain::none && chain(inserted_).begin <= added.begin)
        link = &chain(inserted_).next;
    while (*link != Chain::none && chain(*link).begin <= added.begin)
        link = &chain(*link).next;
    added.next = *link;
    *link = place;
    inserted_ = place;
}

}

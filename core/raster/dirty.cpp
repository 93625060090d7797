#include "core/raster/dirty.hpp"

#include "core/bytes/op_counter.hpp"

#include <algorithm>

namespace kfast::raster {

namespace {

constexpr int far = 0x7FFF;

/// The state of the walk from left to right.
class Walk {
public:
    Walk(const Band& band, std::span<const Record::Border> shown, std::span<const PaintStep> shown_steps,
         const Slots& slots, int columns, bool is_known, RegionList& dirty)
        : band_{band},
          steps_{shown_steps},
          slots_{slots},
          fixed_{slots.same & ~slots.recoloured},
          regions_{dirty.data()},
          end_{dirty.data()},
          columns_{columns},
          is_known_{is_known},
          border_{shown.data()},
          borders_end_{shown.data() + shown.size()}
    {
        take_chain(band.first());
        read_border();
    }

    /// Returns the end of the regions.
    const Region* run()
    {
        int column = 0;
        for (;;) {
            int begin = std::min(begin_, shown_begin_);
            begin = std::min(begin, columns_);
            if (begin > column && !(is_known_ && slots_.looks_same(inside_, shown_inside_)))
                add_flat(column, begin);
            if (begin == columns_)
                return end_;
            column = pass_cluster(begin);
        }
    }

private:
    void take_chain(std::uint32_t place)
    {
        place_ = place;
        begin_ = place == Chain::none ? far : band_.chain(place).begin;
    }
    void read_border() { shown_begin_ = border_ == borders_end_ ? far : border_->begin; }

    /// Returns the end of the cluster.
    int pass_cluster(int begin)
    {
        const SlotMask left = inside_;
        const SlotMask shown_left = shown_inside_;
        const std::uint32_t first = place_;
        const Record::Border* const first_border = border_;
        Region* const mark = end_;
        SlotMask touched = 0;
        unsigned rows = 0;
        int end = begin;
        int chains_end = -1; // of the region
        do {
            if (begin_ <= shown_begin_) {
                const Chain& chain = band_.chain(place_);
                if (chains_end < 0)
                    begin_region(begin);
                else if (begin_ >= chains_end) {
                    end_region(begin_);
                    begin_region(begin_);
                }
                const int chain_end = chain.end;
                chains_end = std::max(chains_end, chain_end);
                end = std::max(end, chain_end);
                const SlotMask bit = bit_of(chain.slot);
                touched |= bit;
                rows |= chain.rows;
                if (chain.is_border)
                    inside_ ^= bit;
                take_chain(chain.next);
            } else {
                count_op(Op::border);
                const SlotMask bit = bit_of(steps_[border_->layer].slot);
                end = std::max<int>(end, border_->end);
                touched |= bit;
                rows |= border_->rows;
                if (border_->is_border != 0)
                    shown_inside_ ^= bit;
                ++border_;
                read_border();
            }
        } while (begin_ < end || shown_begin_ < end);
        const bool is_same_left = left == shown_left && (left & slots_.recoloured) == 0;
        const bool is_same = is_same_left && (touched & ~fixed_) == 0;
        if (is_known_ && (is_same || slots_.is_hidden(left, shown_left, touched)))
            end_ = mark;
        else if (chains_end < 0)
            add_flat(begin, std::min(end, columns_));
        else
            end_region(std::min(end, columns_));
        if (is_known_ && is_same_left && end_ != mark) {
            if ((touched & fixed_) != 0)
                trim(mark, first, first_border);
            else if (rows != all_rows)
                for (Region* region = mark; region != end_; ++region)
                    region->rows = static_cast<RowMask>(rows);
        }
        return end;
    }

    /// Trims the regions of a cluster that was passed: where only unchanged layers are, nothing changes, that
    /// is in rows, in columns to the left, and to the right if the same layers cover what comes then. Each
    /// region is touched by another layer: these are not the only ones that keep the cluster together.
    [[gnu::noinline]] void trim(Region* region, std::uint32_t first, const Record::Border* border)
    {
        int moved_begin = far;
        int moved_end = 0;
        unsigned moved_rows = 0;
        const auto add = [&](unsigned slot, int begin, int end, unsigned rows) {
            if ((bit_of(slot) & fixed_) != 0)
                return;
            moved_begin = std::min(moved_begin, begin);
            moved_end = std::max(moved_end, end);
            moved_rows |= rows;
        };
        for (; first != place_; first = band_.chain(first).next) {
            const Chain& chain = band_.chain(first);
            add(chain.slot, chain.begin, chain.end, chain.rows);
        }
        for (; border != border_; ++border)
            add(steps_[border->layer].slot, border->begin, border->end, border->rows);
        if (inside_ != shown_inside_ || (inside_ & slots_.recoloured) != 0)
            moved_end = columns_;
        for (; region != end_; ++region) {
            region->begin = static_cast<std::int16_t>(std::max<int>(region->begin, moved_begin));
            region->end = static_cast<std::int16_t>(std::min<int>(region->end, moved_end));
            region->rows = static_cast<RowMask>(moved_rows);
        }
    }

    /// Begins a region with the next chain and those after it, up to end_region(). If there is no room, the
    /// last region is extended to it, with all that is between.
    [[gnu::noinline]] void begin_region(int begin)
    {
        if (end_ == regions_ + RegionList::max_count) {
            end_[-1].rows = all_rows;
            return;
        }
        end_->begin = static_cast<std::int16_t>(begin);
        end_->inside = inside_;
        end_->first = place_;
        end_->rows = all_rows;
        end_->has_slots = true;
        ++end_;
    }

    void end_region(int end)
    {
        end_[-1].end = static_cast<std::int16_t>(end);
        end_[-1].behind = place_;
    }

    void add_flat(int begin, int end)
    {
        begin_region(begin);
        end_region(end);
    }

    const Band& band_;
    std::span<const PaintStep> steps_;
    const Slots& slots_;
    const SlotMask fixed_; ///< layers that have not moved, and look as before
    Region* const regions_;
    Region* end_; ///< after the last one
    int columns_;
    bool is_known_;                     ///< whether what the panel shows is known
    std::uint32_t place_ = Chain::none; ///< the chain that comes next
    const Record::Border* border_;      ///< the one that comes next
    const Record::Border* borders_end_;
    int begin_ = 0;
    int shown_begin_ = 0;
    SlotMask inside_ = 0; ///< layers that cover the columns passed last
    SlotMask shown_inside_ = 0;
};

}

void find_dirty(const Band& band, std::span<const Record::Border> shown,
                std::span<const PaintStep> shown_steps, const Slots& slots, int columns, RegionList& dirty)
{
    dirty.end_at(Walk{band, shown, shown_steps, slots, columns, true, dirty}.run());
}

void find_all(const Band& band, const Slots& slots, int columns, RegionList& regions)
{
    regions.end_at(Walk{band, {}, {}, slots, columns, false, regions}.run());
}

Region region_between(const Band& band, int begin, int end)
{
    Region region{.begin = static_cast<std::int16_t>(begin), .end = static_cast<std::int16_t>(end)};
    SlotMask inside = 0;
    int cluster_end = -1;
    std::uint32_t place = band.first();
    const auto begin_cluster = [&] {
        if (cluster_end <= begin) {
            region.inside = inside;
            region.first = place;
        }
    };
    while (place != Chain::none && band.chain(place).begin < std::max(end, cluster_end)) {
        const Chain& chain = band.chain(place);
        if (chain.begin >= cluster_end)
            begin_cluster();
        cluster_end = std::max<int>(cluster_end, chain.end);
        if (chain.is_border)
            inside ^= bit_of(chain.slot);
        place = chain.next;
    }
    begin_cluster();
    region.behind = place;
    return region;
}

}

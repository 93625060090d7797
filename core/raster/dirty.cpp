#include "core/raster/dirty.hpp"

#include "core/work.hpp"

#include <algorithm>

namespace kfast::raster {
namespace {

constexpr int far = 0x7FFF;

/// Where the walk from left to right stands.
class Walk {
public:
    Walk(const Band& band, std::span<const Record::Border> shown, std::span<const PaintStep> shown_steps,
         const Slots& slots, int columns, bool is_known, RegionList& dirty)
        : band_{band}, steps_{shown_steps}, slots_{slots}, dirty_{dirty}, columns_{columns},
          is_known_{is_known}, place_{band.first()}, border_{shown.data()}, borders_end_{shown.data() +
                                                                                         shown.size()}
    {
        read_chain();
        read_border();
    }

    void run()
    {
        int column = 0;
        for (;;) {
            const int begin = std::min({begin_, shown_begin_, columns_});
            if (begin > column && !(is_known_ && slots_.looks_same(inside_, shown_inside_)))
                add_flat(column, begin);
            if (begin == columns_)
                return;
            column = pass_cluster(begin);
        }
    }

private:
    void read_chain() { begin_ = place_ == Chain::none ? far : band_.chain(place_).begin; }
    void read_border() { shown_begin_ = border_ == borders_end_ ? far : border_->begin; }

    /// Returns its end.
    int pass_cluster(int begin)
    {
        const SlotMask left = inside_;
        const SlotMask shown_left = shown_inside_;
        const std::size_t mark = dirty_.size();
        SlotMask touched = 0;
        int end = begin;
        int chains_end = -1; // of the region
        do {
            if (begin_ <= shown_begin_) {
                const Chain& chain = band_.chain(place_);
                if (begin_ >= chains_end)
                    add_region(mark, begin);
                chains_end = std::max<int>(chains_end, chain.end);
                end = std::max<int>(end, chain.end);
                touched |= bit_of(chain.slot);
                if (chain.is_border)
                    inside_ ^= bit_of(chain.slot);
                place_ = chain.next;
                dirty_.back().behind = place_;
                read_chain();
            } else {
                did(Work::border);
                const SlotMask bit = bit_of(steps_[border_->layer].slot);
                end = std::max<int>(end, border_->end);
                touched |= bit;
                if (border_->is_border != 0)
                    shown_inside_ ^= bit;
                ++border_;
                read_border();
            }
        } while (begin_ < end || shown_begin_ < end);
        if (chains_end < 0)
            add_flat(begin, end);
        dirty_.back().end = static_cast<std::int16_t>(std::min(end, columns_));
        const bool is_same = (touched & ~slots_.same) == 0 && left == shown_left &&
                             ((left | touched) & slots_.recoloured) == 0;
        if (is_known_ && (is_same || slots_.is_hidden(left, shown_left, touched)))
            dirty_.shrink(mark);
        return end;
    }

    /// From the chain on that is read now. A cluster that began with less than `mark` regions has regions
    /// without gaps.
    void add_region(std::size_t mark, int cluster_begin)
    {
        const bool is_first = dirty_.size() == mark;
        const int begin = is_first ? cluster_begin : begin_;
        if (!is_first)
            dirty_.back().end = static_cast<std::int16_t>(begin);
        dirty_.add(begin, inside_, place_);
    }

    void add_flat(int begin, int end)
    {
        dirty_.add(begin, inside_, place_);
        dirty_.extend(end, place_);
    }

    const Band& band_;
    std::span<const PaintStep> steps_;
    const Slots& slots_;
    RegionList& dirty_;
    int columns_;
    bool is_known_;                ///< what the panel shows
    std::uint32_t place_;          ///< of the chain that comes next
    const Record::Border* border_; ///< that comes next
    const Record::Border* borders_end_;
    int begin_ = 0;
    int shown_begin_ = 0;
    SlotMask inside_ = 0; ///< layers that cover what was passed last
    SlotMask shown_inside_ = 0;
};

}

void find_dirty(const Band& band, std::span<const Record::Border> shown,
                std::span<const PaintStep> shown_steps, const Slots& slots, int columns, RegionList& dirty)
{
    dirty.clear();
    Walk{band, shown, shown_steps, slots, columns, true, dirty}.run();
}

void find_all(const Band& band, const Slots& slots, int columns, RegionList& regions)
{
    regions.clear();
    Walk{band, {}, {}, slots, columns, false, regions}.run();
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

// LayerRow where a layer has more chains in a band than its list takes.

#include "core/raster/layer_row.hpp"

#include "core/bytes/op_counter.hpp"

#include <algorithm>

namespace kfast::raster {

/// Chains of the layer whose columns overlap in the band are looked at together: a group of edges that share
/// pixels has no others.
void LayerRow::add_many(int row)
{
    std::int32_t winding = (winding_ >> band_->height_bits()) + add_left_of_panel(row);
    Cluster cluster{first_, first_};
    int end = 0; // of its columns
    for (std::uint32_t place = first_; place != behind_; place = band_->chain(place).next) {
        const Chain& chain = band_->chain(place);
        count_op(Op::chain_visit);
        if (chain.layer != layer_)
            continue;
        if (chain.begin > end) {
            cluster.behind = place;
            winding = add_cluster(cluster, row, winding);
            cluster.first = place;
        }
        end = std::max<int>(end, chain.end);
    }
    cluster.behind = behind_;
    add_cluster(cluster, row, winding);
}

/// Calls visit(chain) for the chains of the layer that reach the row, or are left of the panel in it.
void LayerRow::each_left_chain(int row, FunctionRef<void(const RowChain&)> visit) const
{
    for (std::uint32_t place = first_; place != behind_; place = band_->chain(place).next) {
        const Chain& chain = band_->chain(place);
        if (chain.begin != 0)
            return;
        if (RowChain found; chain.layer == layer_ && find_row_chain(chain, row, found))
            visit(found);
    }
}

/// Chains that are left of the panel, and those of a group that reaches into it, count by their heights
/// alone, however many they are. Returns the winding to the right of them.
std::int32_t LayerRow::add_left_of_panel(int row)
{
    begin_ = -left_;
    for (int before = no_pixel; before != begin_;) {
        before = begin_;
        each_left_chain(row, [&](const RowChain& chain) {
            if (chain.last >= begin_)
                begin_ = std::min(begin_, chain.first);
        });
    }
    std::int32_t height = 0;
    each_left_chain(row, [&](const RowChain& chain) {
        if (chain.last >= begin_)
            return;
        add_chain(chain, columns_, sums_);
        height += chain.height();
    });
    return height / grid;
}

/// Calls visit(chain, its first column in the band), until that returns false, for all chains of the layer in
/// the cluster that reach the panel within the row. Some to the right are in a higher band, but not in a
/// lower one. Those that begin left of the panel come in any order: for all of them the column is begin_.
void LayerRow::each_chain(const Cluster& cluster, int row,
                          FunctionRef<bool(const RowChain&, int)> visit) const
{
    const int right = band_->panel_width() - left_;
    for (std::uint32_t place = cluster.first; place != cluster.behind; place = band_->chain(place).next) {
        const Chain& chain = band_->chain(place);
        count_op(Op::chain_visit);
        RowChain found;
        if (chain.layer == layer_ && find_row_chain(chain, row, found) && found.first < right &&
            found.last >= begin_ && !visit(found, chain.begin == 0 ? begin_ : chain.begin - left_))
            return;
    }
}

/// Chains come in the order of their columns in the band: what is left of these is complete. Returns the
/// winding to the right of the cluster.
std::int32_t LayerRow::add_cluster(const Cluster& cluster, int row, std::int32_t winding)
{
    std::size_t count = 0;
    int done = -no_pixel; // groups to the left of here are added
    bool is_crowd = false;
    each_chain(cluster, row, [&](const RowChain& chain, int begin) {
        if (count == max_group || begin >= columns_)
            winding = add_groups(count, begin, winding);
        if (begin >= columns_ && (count == 0 || group_[0].first >= columns_)) {
            count = 0;
            return false; // the rest is not in the tile
        }
        is_crowd = count == max_group;
        if (is_crowd)
            done = std::min(begin, group_[0].first);
        else {
            group_[count] = chain;
            sort_last(++count);
        }
        return !is_crowd;
    });
    return is_crowd ? add_crowd(cluster, row, done, winding) : add_groups(count, no_pixel, winding);
}

/// Adds the groups from a pixel on, if there are so many chains that each group has to be looked for.
std::int32_t LayerRow::add_crowd(const Cluster& cluster, int row, int begin, std::int32_t winding)
{
    for (;;) {
        const int last = end_of_group(cluster, row, begin);
        if (last == no_pixel)
            return winding;
        std::size_t count = 0;
        const auto each_of_group = [&](FunctionRef<void(const RowChain&)> visit) {
            each_chain(cluster, row, [&](const RowChain& chain, int band_begin) {
                if (chain.first >= begin && chain.first <= last)
                    visit(chain);
                return band_begin <= last;
            });
        };
        each_of_group([&](const RowChain& chain) {
            if (count < max_group)
                group_[count] = chain;
            ++count;
        });
        if (count <= max_group)
            winding = add_group(std::span{group_}.first(count), rule_, winding, columns_, sums_);
        else
            winding = add_large_group(each_of_group, winding);
        begin = last + 1;
    }
}

/// Adds a group line by line, and each line part by part.
std::int32_t LayerRow::add_large_group(EachChain each_chain, std::int32_t winding)
{
    int first = no_pixel;
    int last = -no_pixel;
    std::int32_t height = 0;
    each_chain([&](const RowChain& chain) {
        first = std::min(first, chain.first);
        last = std::max(last, chain.last);
        height += chain.height();
    });
    const std::int32_t right = winding + height / grid;
    begin_inside(first, rule_, winding, columns_, sums_);
    for (int number = 0; number != SampleLine::count_in_row; ++number) {
        SampleLine line{number};
        std::int32_t passed = winding;
        do {
            line.begin_part();
            each_chain([&](const RowChain& chain) { line.add(chain); });
            passed = line.add_inside(rule_, passed, columns_, sums_);
        } while (!line.is_complete());
    }
    end_inside(last + 1, rule_, right, columns_, sums_);
    return right;
}

/// The last pixel of the first group whose pixels are at `begin` or further to the right; no_pixel if there
/// is none.
int LayerRow::end_of_group(const Cluster& cluster, int row, int begin) const
{
    int last = no_pixel;
    each_chain(cluster, row, [&](const RowChain& chain, int band_begin) {
        if (chain.first >= begin)
            last = std::min(last, chain.first);
        return band_begin <= last;
    });
    for (int before = no_pixel; before != last;) {
        before = last;
        each_chain(cluster, row, [&](const RowChain& chain, int band_begin) {
            if (chain.first >= begin && chain.first <= last)
                last = std::max(last, chain.last);
            return band_begin <= last;
        });
    }
    return last;
}

}

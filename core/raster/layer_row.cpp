#include "core/raster/layer_row.hpp"

#include "core/work.hpp"

#include <algorithm>
#include <utility>

namespace kfast::raster {
namespace {

/// How a chain goes through a row.
enum class Way : std::uint8_t {
    none,     ///< it does not reach it
    straight, ///< from border to border, as one edge
    other,
};

constexpr int no_pixel = 1 << 20; ///< further to the right than any

/// Of chains that are in order but for the last one.
void sort_by_pixel(std::span<RowChain> chains)
{
    for (std::size_t place = chains.size() - 1; place != 0 && chains[place - 1].first > chains[place].first;
         --place)
        std::swap(chains[place - 1], chains[place]);
}

Way way_through(const Band& band, const Chain& chain, int row)
{
    if (chain.is_whole)
        return Way::straight;
    const std::int32_t top = (band.top_row() + row) * grid;
    if (chain.bottom <= top || chain.top >= top + grid)
        return Way::none;
    if (chain.top > top || chain.bottom < top + grid)
        return Way::other;
    const std::int32_t origin = chain.top & -grid;
    const Bend* bend = band.bends(chain);
    while (bend->y <= top - origin && chain.top != top)
        --bend;
    return bend->y <= top + grid - origin ? Way::other : Way::straight;
}

}

bool LayerRow::begin(const Band& band, const Region& region, std::uint16_t layer, FillRule rule, int left,
                     int columns)
{
    band_ = &band;
    layer_ = layer;
    rule_ = rule;
    left_ = left;
    columns_ = columns;
    const bool has_any = find_chains(region);
    are_apart_ = are_apart_ && has_few_;
    if (are_apart_)
        keep_borders();
    return has_any;
}

/// Clusters to the left of the tile count by their winding alone, and those to the right of it not at all.
bool LayerRow::find_chains(const Region& region)
{
    chain_count_ = 0;
    has_few_ = are_apart_ = true;
    behind_ = region.behind;
    bool has_any = false;
    int end = 0; // of the columns of the cluster
    std::int32_t winding = 0;
    for (std::uint32_t place = region.first; place != region.behind;) {
        const Chain& chain = band_->chain(place);
        const std::uint32_t here = std::exchange(place, chain.next);
        did(Work::chain_visit);
        if (chain.layer != layer_)
            continue;
        if (!has_any)
            winding = region.first == band_->first() ? 0 : chain.winding;
        if (!has_any || chain.begin > end) {
            if (has_any && chain.begin >= left_ + columns_) {
                behind_ = here;
                break;
            }
            if (!has_any || end <= left_) {
                first_ = here;
                chain_count_ = 0;
                has_few_ = are_apart_ = true;
                winding_ = winding;
            }
        }
        are_apart_ = are_apart_ && chain.is_whole && (chain_count_ == 0 || chain.begin >= end);
        has_any = true;
        winding += chain.height;
        end = std::max<int>(end, chain.end);
        has_few_ = has_few_ && chain_count_ != max_edges;
        if (has_few_)
            chains_[chain_count_++] = &chain;
    }
    if (end <= left_) {
        first_ = behind_;
        chain_count_ = 0;
        has_few_ = are_apart_ = true;
        winding_ = winding;
    }
    return has_any;
}

/// Leaves those between inside and outside in the list.
void LayerRow::keep_borders()
{
    std::int32_t winding = winding_ >> band_->height_bits();
    bool was_inside = is_inside(rule_, winding);
    const std::size_t count = std::exchange(chain_count_, 0);
    for (std::size_t i = 0; i != count; ++i) {
        winding += chains_[i]->runs_down ? 1 : -1;
        if (is_inside(rule_, winding) == was_inside)
            continue;
        was_inside = !was_inside;
        chains_[chain_count_++] = chains_[i];
    }
}

RowEdge LayerRow::edge_of(const Chain& chain, int row) const
{
    const std::int32_t left = (left_ - chain.left) * grid;
    if (chain.is_straight)
        return edge_between(band_->crossing(chain, row) - left, band_->crossing(chain, row + 1) - left);
    const Crossing* const x = band_->kept_crossings(chain) + row;
    return edge_between(x[0] - left, x[1] - left);
}

bool LayerRow::find_edges(int row)
{
    edge_count_ = 0;
    if (!has_few_)
        return false;
    if (are_apart_) {
        did(Work::layer_edge, static_cast<std::uint32_t>(chain_count_));
        for (; edge_count_ != chain_count_; ++edge_count_)
            edges_[edge_count_] = edge_of(*chains_[edge_count_], row);
        return true;
    }
    std::int32_t winding = winding_ >> band_->height_bits();
    bool was_inside = is_inside(rule_, winding);
    int past = -1; // the last pixel of the edge before
    for (std::size_t i = 0; i != chain_count_; ++i) {
        const Chain& chain = *chains_[i];
        did(Work::layer_edge);
        if (!chain.is_whole) {
            const Way way = way_through(*band_, chain, row);
            if (way == Way::none)
                continue;
            if (way == Way::other)
                return false;
        }
        const RowEdge edge = edge_of(chain, row);
        if (edge.pixel() <= past || edge.high > columns_ * grid)
            return false;
        past = floor_pixel(edge.high);
        winding += chain.runs_down ? 1 : -1;
        if (is_inside(rule_, winding) == was_inside)
            continue;
        edges_[edge_count_++] = edge;
        was_inside = !was_inside;
    }
    return true;
}

void LayerRow::add_row(int row)
{
    did(Work::sum_row);
    did(Work::sum_pixel, static_cast<std::uint32_t>(columns_));
    if (has_few_)
        add_few(row);
    else
        add_many(row);
}

void LayerRow::add_few(int row)
{
    const int right = band_->panel_width() - left_;
    std::size_t count = 0;
    for (std::size_t i = 0; i != chain_count_; ++i)
        if (find_row_chain(*chains_[i], row, group_[count]) && group_[count].first < right)
            sort_by_pixel(std::span{group_}.first(++count));
    add_groups(count, no_pixel, winding_ >> band_->height_bits());
}

/// Chains of the layer whose columns overlap in the band are looked at together: a group of edges that share
/// pixels has no others.
void LayerRow::add_many(int row)
{
    std::int32_t winding = (winding_ >> band_->height_bits()) + add_left_of_panel(row);
    Cluster cluster{first_, first_};
    int end = 0; // of its columns
    for (std::uint32_t place = first_; place != behind_; place = band_->chain(place).next) {
        const Chain& chain = band_->chain(place);
        did(Work::chain_visit);
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

/// Calls visit(chain) for the chains of the layer that reach the row, or lie left of the panel in it.
template <class Visit>
void LayerRow::each_left_chain(int row, Visit visit) const
{
    for (std::uint32_t place = first_; place != behind_; place = band_->chain(place).next) {
        const Chain& chain = band_->chain(place);
        if (chain.begin != 0)
            return;
        if (RowChain found; chain.layer == layer_ && find_row_chain(chain, row, found))
            visit(found);
    }
}

/// Chains that lie left of the panel, and of a group that reaches into it, count by their heights alone,
/// however many they are. Returns the winding to the right of them.
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
/// lower one.
template <class Visit>
void LayerRow::each_chain(const Cluster& cluster, int row, Visit visit) const
{
    const int right = band_->panel_width() - left_;
    for (std::uint32_t place = cluster.first; place != cluster.behind; place = band_->chain(place).next) {
        const Chain& chain = band_->chain(place);
        did(Work::chain_visit);
        RowChain found;
        if (chain.layer == layer_ && find_row_chain(chain, row, found) && found.first < right && found.last >= begin_ &&
            !visit(found, chain.begin - left_))
            return;
    }
}

/// Chains come in the order of their columns in the band: what lies left of these is complete. Returns the
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
            return false; // nothing of the tile is left
        }
        is_crowd = count == max_group;
        if (is_crowd)
            done = std::min(begin, group_[0].first);
        else {
            group_[count] = chain;
            sort_by_pixel(std::span{group_}.first(++count));
        }
        return !is_crowd;
    });
    return is_crowd ? add_crowd(cluster, row, done, winding) : add_groups(count, no_pixel, winding);
}

/// Of the first `count` chains of group_, whose count becomes that of the others, the groups that end before
/// a pixel, and reach the tile or lie to the left of it. Returns the winding to the right of them.
std::int32_t LayerRow::add_groups(std::size_t& count, int limit, std::int32_t winding)
{
    std::size_t begin = 0;
    while (begin != count && group_[begin].first < columns_) {
        std::size_t end = begin;
        int last = group_[begin].last;
        for (; end != count && group_[end].first <= last; ++end)
            last = std::max(last, group_[end].last);
        if (last >= limit)
            break;
        winding = add_group(std::span{group_}.subspan(begin, end - begin), rule_, winding, columns_, sums_);
        begin = end;
    }
    std::copy(group_.begin() + static_cast<std::ptrdiff_t>(begin),
              group_.begin() + static_cast<std::ptrdiff_t>(count), group_.begin());
    count -= begin;
    return winding;
}

/// From a pixel on, if there are so many chains that each group has to be looked for.
std::int32_t LayerRow::add_crowd(const Cluster& cluster, int row, int begin, std::int32_t winding)
{
    for (;;) {
        const int last = end_of_group(cluster, row, begin);
        if (last == no_pixel)
            return winding;
        std::size_t count = 0;
        const auto each_of_group = [&](auto visit) {
            each_chain(cluster, row, [&](const RowChain& chain, int) {
                if (chain.first >= begin && chain.first <= last)
                    visit(chain);
                return true;
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
            winding = add_large_group(each_of_group, count, winding);
        begin = last + 1;
    }
}

/// Line by line, unless it is so large that its areas have to add up.
template <class EachChain>
std::int32_t LayerRow::add_large_group(EachChain each_chain, std::size_t count, std::int32_t winding)
{
    int first = no_pixel;
    int last = -no_pixel;
    std::int32_t height = 0;
    each_chain([&](const RowChain& chain) {
        first = std::min(first, chain.first);
        last = std::max(last, chain.last);
        height += chain.height();
        if (count > Line::max_count)
            add_chain(chain, columns_, sums_);
    });
    const std::int32_t right = winding + height / grid;
    if (count > Line::max_count)
        return right;
    begin_inside(first, rule_, winding, columns_, sums_);
    for (int number = 0; number != Line::count_in_row; ++number) {
        Line line{number};
        each_chain([&](const RowChain& chain) { line.add(chain); });
        line.add_inside(rule_, winding, columns_, sums_);
    }
    end_inside(last + 1, rule_, right, columns_, sums_);
    return right;
}

/// The last pixel of the first group whose pixels lie at `begin` or further to the right; no_pixel if there
/// is none.
int LayerRow::end_of_group(const Cluster& cluster, int row, int begin) const
{
    int last = no_pixel;
    each_chain(cluster, row, [&](const RowChain& chain, int) {
        if (chain.first >= begin)
            last = std::min(last, chain.first);
        return true;
    });
    for (int before = no_pixel; before != last;) {
        before = last;
        each_chain(cluster, row, [&](const RowChain& chain, int) {
            if (chain.first >= begin && chain.first <= last)
                last = std::max(last, chain.last);
            return true;
        });
    }
    return last;
}

/// False if the chain does not reach the row.
bool LayerRow::find_row_chain(const Chain& chain, int row, RowChain& found) const
{
    const Way way = way_through(*band_, chain, row);
    if (way == Way::none)
        return false;
    did(Work::row_chain);
    const std::int32_t origin = chain.top & -grid;
    const std::int32_t top = (band_->top_row() + row) * grid;
    const std::int32_t left = (left_ - chain.left) * grid;
    found.top_x = band_->crossing(chain, row) - left;
    found.bottom_x = band_->crossing(chain, row + 1) - left;
    found.bend = band_->bends(chain);
    found.left = left;
    found.top = top - origin;
    found.from = std::max<std::int32_t>(chain.top - top, 0);
    found.to = std::min(chain.bottom - top, grid);
    found.runs_down = chain.runs_down;
    found.is_straight = way == Way::straight;
    found.begins = chain.top >= top;
    found.find_pixels();
    return true;
}

std::int32_t LayerRow::coverage_of(std::int32_t sum) const
{
    std::int32_t area = sum < 0 ? -sum : sum;
    if (rule_ == FillRule::even_odd) {
        area &= 2 * CoverageSums::full - 1;
        area = std::min(area, 2 * CoverageSums::full - area);
    }
    return (std::min(area, CoverageSums::full) + CoverageSums::full / full_coverage / 2) /
           (CoverageSums::full / full_coverage);
}

}

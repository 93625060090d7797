#include "core/raster/layer_row.hpp"

#include "core/bytes/op_counter.hpp"

#include <algorithm>
#include <utility>

namespace kfast::raster {
namespace {

/// How a chain goes through a row.
enum class Way : std::uint8_t {
    none,     ///< it does not reach it
    straight, ///< from border to border, as one edge
    bent,     ///< from border to border
    other,
};

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
    return bend->y <= top + grid - origin ? Way::bent : Way::straight;
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
        find_borders();
    return has_any;
}

/// Clusters to the left of the tile count by their winding alone, and those to the right of it not at all.
bool LayerRow::find_chains(const Region& region)
{
    begin_list(region.first, 0);
    behind_ = region.behind;
    bool has_any = false;
    int end = 0; // of the columns of the cluster
    std::int32_t winding = 0;
    for (std::uint32_t place = region.first; place != region.behind;) {
        const Chain& chain = band_->chain(place);
        const std::uint32_t here = std::exchange(place, chain.next);
        count_op(Op::chain_visit);
        if (chain.layer != layer_)
            continue;
        if (!has_any)
            winding = region.first == band_->first() ? 0 : chain.winding;
        if (!has_any || chain.begin > end) {
            if (has_any && chain.begin >= left_ + columns_) {
                behind_ = here;
                break;
            }
            if (!has_any || end <= left_)
                begin_list(here, winding);
        }
        are_apart_ = are_apart_ && chain.is_whole && (chain_count_ == 0 || chain.begin >= end);
        has_any = true;
        winding += chain.height;
        end = std::max<int>(end, chain.end);
        has_few_ = has_few_ && chain_count_ != max_edges;
        if (has_few_)
            chains_[chain_count_++] = {&chain, band_->crossings(chain, 0), (left_ - chain.left) * grid};
    }
    if (end <= left_)
        begin_list(behind_, winding);
    return has_any;
}

/// `winding` is that to the left of the first chain, in the unit of Chain::winding.
void LayerRow::begin_list(std::uint32_t first, std::int32_t winding)
{
    first_ = first;
    winding_ = winding;
    chain_count_ = 0;
    has_few_ = are_apart_ = true;
}

/// Finds those chains in the list that are between inside and outside.
void LayerRow::find_borders()
{
    std::int32_t winding = winding_ >> band_->height_bits();
    bool was_inside = is_inside(rule_, winding);
    edge_count_ = 0;
    for (std::size_t i = 0; i != chain_count_; ++i) {
        winding += chains_[i].chain->runs_down ? 1 : -1;
        if (is_inside(rule_, winding) == was_inside)
            continue;
        was_inside = !was_inside;
        borders_[edge_count_++] = &chains_[i];
    }
}

bool LayerRow::find_edges(int row)
{
    if (are_apart_) {
        count_op(Op::layer_edge, static_cast<std::uint32_t>(edge_count_));
        row_ = row;
        return true;
    }
    if (!has_few_)
        return false;
    edge_count_ = 0;
    std::int32_t winding = winding_ >> band_->height_bits();
    bool was_inside = is_inside(rule_, winding);
    int past = -1; // the last pixel of the edge before
    RowChain* bent = group_.data();
    for (std::size_t i = 0; i != chain_count_; ++i) {
        const Chain& chain = *chains_[i].chain;
        count_op(Op::layer_edge);
        const Way way = chain.is_whole ? Way::straight : way_through(*band_, chain, row);
        if (way == Way::none)
            continue;
        if (way == Way::other)
            return false;
        RowEdge edge{};
        if (way == Way::bent) {
            set_row_chain(chain, row, false, *bent);
            edge = {bent->first * grid, (bent->last + 1) * grid - 1};
        } else {
            edge = chains_[i].edge(row);
        }
        if (edge.pixel() <= past || edge.high > columns_ * grid)
            return false;
        past = floor_pixel(edge.high);
        winding += chain.runs_down ? 1 : -1;
        if (is_inside(rule_, winding) == was_inside)
            continue;
        bent_[edge_count_] = way == Way::bent ? bent++ : nullptr;
        edges_[edge_count_++] = edge;
        was_inside = !was_inside;
    }
    return true;
}

void LayerRow::cover_edge(std::size_t number, bool is_inside_left, CoverageRun& run)
{
    if (are_apart_)
        return cover(borders_[number]->edge(row_), columns_, run);
    const RowChain* const bent = bent_[number];
    if (bent == nullptr)
        return cover(edges_[number], columns_, run);
    count_op(Op::bent_edge);
    add_chain(*bent, columns_, sums_);
    run.begin = bent->first;
    run.end = bent->last + 1;
    sums_.take(bent->runs_down, is_inside_left, run);
}

void LayerRow::add_row(int row)
{
    count_op(Op::sum_row);
    count_op(Op::sum_pixel, static_cast<std::uint32_t>(columns_));
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
        if (find_row_chain(*chains_[i].chain, row, group_[count]) && group_[count].first < right)
            sort_last(++count);
    add_groups(count, no_pixel, winding_ >> band_->height_bits());
}

/// Sorts the first `count` chains of group_, which are in order by their first pixels except the last.
void LayerRow::sort_last(std::size_t count)
{
    for (std::size_t place = count - 1; place != 0 && group_[place - 1].first > group_[place].first; --place)
        std::swap(group_[place - 1], group_[place]);
}

/// Adds those groups of the first `count` chains of group_ that end before pixel `limit`, and reach the tile
/// or are left of it; `count` is set to that of the other chains. Returns the winding to the right of them.
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
    if (begin != 0)
        std::copy(group_.begin() + begin, group_.begin() + count, group_.begin());
    count -= begin;
    return winding;
}

/// Returns false if the chain does not reach the row.
bool LayerRow::find_row_chain(const Chain& chain, int row, RowChain& found) const
{
    const Way way = way_through(*band_, chain, row);
    if (way != Way::none)
        set_row_chain(chain, row, way == Way::straight, found);
    return way != Way::none;
}

void LayerRow::set_row_chain(const Chain& chain, int row, bool is_straight, RowChain& found) const
{
    count_op(Op::row_chain);
    const std::int32_t origin = chain.top & -grid;
    const std::int32_t top = (band_->top_row() + row) * grid;
    const std::int32_t left = (left_ - chain.left) * grid;
    const Crossing* const x = band_->crossings(chain, row);
    found.top_x = x[0] - left;
    found.bottom_x = x[1] - left;
    found.bend = band_->bends(chain);
    found.left = left;
    found.top = top - origin;
    found.from = std::max<std::int32_t>(chain.top - top, 0);
    found.to = std::min(chain.bottom - top, grid);
    found.runs_down = chain.runs_down;
    found.is_straight = is_straight;
    found.begins = chain.top >= top;
    found.find_pixels();
}

std::int32_t LayerRow::coverage_of(std::int32_t sum) const
{
    std::int32_t area = sum < 0 ? -sum : sum;
    if (rule_ == FillRule::even_odd) {
        area &= 2 * CoverageSums::full - 1;
        area = std::min(area, 2 * CoverageSums::full - area);
    }
    return CoverageSums::coverage(area);
}

}

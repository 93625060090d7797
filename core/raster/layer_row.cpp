#include "core/raster/layer_row.hpp"

#include <algorithm>

namespace kfast::raster {
namespace {

/// How a chain goes through a row.
enum class Way : std::uint8_t {
    none,     ///< it does not reach it
    straight, ///< from border to border, as one edge
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
    return bend->y <= top + grid - origin ? Way::other : Way::straight;
}

}

bool LayerRow::begin(const Band& band, const Region& region, std::uint16_t layer, FillRule rule, int left,
                     int columns)
{
    band_ = &band;
    first_ = region.first;
    behind_ = region.behind;
    layer_ = layer;
    rule_ = rule;
    left_ = left;
    columns_ = columns;
    chain_count_ = 0;
    has_few_ = true;
    bool has_any = false;
    for (std::uint32_t place = region.first; place != region.behind;) {
        const Chain& chain = band.chain(place);
        place = chain.next;
        if (chain.layer != layer)
            continue;
        if (!has_any)
            winding_ = region.first == band.first() ? 0 : chain.winding;
        has_any = true;
        has_few_ = chain_count_ != max_edges;
        if (has_few_)
            chains_[chain_count_++] = &chain;
    }
    return has_any;
}

bool LayerRow::is_inside(std::int32_t winding) const
{
    return rule_ == FillRule::nonzero ? winding != 0 : (winding >> band_->height_bits() & 1) != 0;
}

RowEdge LayerRow::edge_of(const Chain& chain, int row) const
{
    const Crossing* const x = band_->crossings(chain) + row;
    const std::int32_t left = (left_ - chain.left) * grid;
    return edge_between(x[0] - left, x[1] - left);
}

bool LayerRow::find_edges(int row)
{
    edge_count_ = 0;
    if (!has_few_)
        return false;
    const std::int32_t whole = 1 << band_->height_bits();
    std::int32_t winding = winding_;
    int past = -1; // the last pixel of the edge before
    for (std::size_t i = 0; i != chain_count_; ++i) {
        const Chain& chain = *chains_[i];
        const Way way = way_through(*band_, chain, row);
        if (way == Way::none)
            continue;
        if (way == Way::other)
            return false;
        const RowEdge edge = edge_of(chain, row);
        if (edge.pixel() <= past || edge.high > columns_ * grid)
            return false;
        past = floor_pixel(edge.high);
        const std::int32_t right = winding + (chain.runs_down ? whole : -whole);
        if (is_inside(winding) != is_inside(right))
            edges_[edge_count_++] = edge;
        winding = right;
    }
    return true;
}

void LayerRow::add_row(int row)
{
    for (std::uint32_t place = first_; place != behind_;) {
        const Chain& chain = band_->chain(place);
        place = chain.next;
        if (chain.layer != layer_)
            continue;
        const Way way = way_through(*band_, chain, row);
        if (way == Way::straight)
            sums_.add(edge_of(chain, row), chain.runs_down ? 1 : -1, columns_);
        else if (way == Way::other)
            add_parts(chain, row);
    }
}

/// Of a chain that begins, ends or bends in the row.
void LayerRow::add_parts(const Chain& chain, int row)
{
    constexpr std::int32_t unit = CoverageSums::part_height / grid;
    const std::int32_t origin = chain.top & -grid;
    const std::int32_t top = (band_->top_row() + row) * grid;
    const std::int32_t from = std::max(top, chain.top) - origin;
    const std::int32_t to = std::min(top + grid, chain.bottom) - origin;
    const std::int32_t left = (left_ - chain.left) * grid;
    const Crossing* const crossings = band_->crossings(chain) + row;
    std::int32_t x = crossings[0] - left;
    std::int32_t y = from;
    const auto line_to = [&](std::int32_t next_x, std::int32_t next_y) {
        const std::int32_t height = (next_y - y) * unit;
        sums_.add_part(x, next_x, chain.runs_down ? height : -height, columns_);
        x = next_x;
        y = next_y;
    };
    for (const Bend* bend = band_->bends(chain); bend->y <= to; --bend)
        if (bend->y > from || from == chain.top - origin)
            line_to(bend->x - left, bend->y);
    line_to(crossings[1] - left, to);
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

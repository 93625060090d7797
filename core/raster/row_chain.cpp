#include "core/raster/row_chain.hpp"

#include "core/bytes/op_counter.hpp"
#include "core/raster/outline/grid.hpp"

#include <algorithm>
#include <cstddef>

namespace kfast::raster {

namespace {

/// A part of an edge's height, in 1/2^part_bits.
constexpr int part_bits = 12;

std::int32_t part_of(std::int32_t part, std::int32_t height)
{
    return part * reciprocals[static_cast<std::size_t>(height)] >> (16 - part_bits);
}

}

void RowChain::find_pixels()
{
    if (is_straight) {
        first = floor_pixel(std::min(top_x, bottom_x));
        last = std::max(ceil_pixel(std::max(top_x, bottom_x)) - 1, first);
        return;
    }
    std::int32_t low = top_x;
    std::int32_t high = low;
    each_edge([&](std::int32_t, std::int32_t, std::int32_t x, std::int32_t) {
        low = x < low ? x : low;
        high = x > high ? x : high;
    });
    first = floor_pixel(low);
    last = floor_pixel(high);
}

std::int32_t RowChain::x_at(std::int32_t y) const
{
    if (is_straight)
        return top_x + ((bottom_x - top_x) * y >> grid_bits);
    if (y >= to)
        return bottom_x;
    std::int32_t upper_x = top_x;
    std::int32_t upper_y = from;
    const Bend* next = bend;
    for (; next->y <= top + y; --next)
        if (has(*next)) {
            upper_x = next->x - left;
            upper_y = next->y - top;
        }
    const bool is_last = next->y > top + to;
    const std::int32_t lower_x = is_last ? bottom_x : next->x - left;
    const std::int32_t lower_y = is_last ? to : next->y - top;
    return upper_x + ((lower_x - upper_x) * part_of(y - upper_y, lower_y - upper_y) >> part_bits);
}

void SampleLine::begin_part()
{
    is_first_ = count_ == 0;
    if (!is_first_)
        before_ = crossings_[count_ - 1];
    count_ = 0;
    added_ = 0;
    has_more_ = false;
}

void SampleLine::add(const RowChain& chain)
{
    if (y_ < chain.from || y_ >= chain.to)
        return;
    count_op(Op::line_crossing);
    const Crossing added{2 * chain.x_at(y_) + (chain.runs_down ? 0 : 1), added_++};
    if (!is_first_ && (added.x2 < before_.x2 || (added.x2 == before_.x2 && added.number <= before_.number)))
        return;
    if (count_ == max_count) {
        has_more_ = true;
        if (added.x2 >= crossings_[max_count - 1].x2)
            return;
        --count_;
    }
    std::size_t place = count_++;
    for (; place != 0 && crossings_[place - 1].x2 > added.x2; --place)
        crossings_[place] = crossings_[place - 1];
    crossings_[place] = added;
}

std::int32_t SampleLine::add_inside(FillRule rule, std::int32_t winding, int columns,
                                    CoverageSums& sums) const
{
    constexpr std::int32_t height = CoverageSums::part_height / count_in_row;
    bool was_inside = is_inside(rule, winding);
    for (std::size_t i = 0; i != count_; ++i) {
        winding += step(i);
        if (is_inside(rule, winding) == was_inside)
            continue;
        const std::int32_t x = crossings_[i].x2 >> 1;
        sums.add_part(x, x, was_inside ? -height : height, columns);
        was_inside = !was_inside;
    }
    return winding;
}

}

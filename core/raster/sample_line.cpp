#include "core/raster/sample_line.hpp"

#include "core/bytes/op_counter.hpp"

namespace kfast::raster {

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

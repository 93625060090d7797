#include "core/coverage_row.hpp"

#include <utility>

namespace kfast {
namespace {

constexpr std::int32_t columns = 1024; ///< sub-columns of a pixel

std::int32_t to_column(Fixed x) { return (x.raw() + 32) >> 6; }

/// The part of `height` in which an edge that runs over `run` columns covers the first `part` of them.
std::int32_t share_of(std::int32_t height, std::int32_t part, std::int32_t run)
{
    return static_cast<std::int32_t>(std::int64_t{height} * part / run);
}

}

void CoverageRow::add(Fixed top, Fixed bottom, std::int32_t height, std::int32_t sign)
{
    auto [left, right] = std::minmax({to_column(top), to_column(bottom)});
    const std::int32_t edge_of_row = width_ * columns;
    if (left >= edge_of_row)
        return;
    if (left < 0) {
        const std::int32_t outside = right <= 0 ? height : share_of(height, -left, right - left);
        add_within(0, 0, outside, sign);
        height -= outside;
        left = 0;
    }
    if (right > edge_of_row) {
        height = share_of(height, edge_of_row - left, right - left);
        right = edge_of_row;
    }
    if (height != 0)
        add_within(left, right, height, sign);
}

void CoverageRow::add_within(std::int32_t left, std::int32_t right, std::int32_t height, std::int32_t sign)
{
    const int first = left / columns;
    const int last = right / columns;
    first_ = std::min(first_, first);
    last_ = std::max(last_, last + 1);
    if (first == last)
        deposit(first, sign * height, left % columns + right % columns);
    else
        add_across(left, right, height, sign);
}

/// The height is divided over the pixels by whole sub-rows, the remainder carried along: nothing is lost.
void CoverageRow::add_across(std::int32_t left, std::int32_t right, std::int32_t height, std::int32_t sign)
{
    const std::int32_t run = right - left;
    const std::int32_t first = left / columns;
    const std::int32_t last = right / columns;
    const std::int32_t in_first = columns - left % columns;
    std::int32_t part = height * in_first / run;
    std::int32_t carry = height * in_first % run;
    std::int32_t rest = height - part;
    deposit(first, sign * part, left % columns + columns);
    const std::int32_t each = height * columns / run;
    const std::int32_t each_carry = height * columns % run;
    for (std::int32_t cell = first + 1; cell < last; ++cell) {
        carry += each_carry;
        part = each + (carry >= run ? 1 : 0);
        carry -= carry >= run ? run : 0;
        rest -= part;
        deposit(cell, sign * part, columns);
    }
    deposit(last, sign * rest, right % columns);
}

/// `ends` is the sum of the columns within the pixel where the edge begins and ends.
void CoverageRow::deposit(std::int32_t cell, std::int32_t height, std::int32_t ends)
{
    const auto index = static_cast<std::size_t>(cell);
    cells_[index] += height * (2 * columns - ends);
    cells_[index + 1] += height * ends;
}

}

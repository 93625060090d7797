#include "core/coverage_row.hpp"

#include <algorithm>
#include <utility>

namespace kfast {
namespace {

constexpr int column_bits = 10;
constexpr std::int32_t columns = 1 << column_bits; ///< sub-columns of a pixel

/// The part of `height` in which an edge that runs over `run` columns covers the first `part` of them.
std::int32_t share_of(std::int32_t height, std::int32_t part, std::int32_t run)
{
    return static_cast<std::int32_t>(std::int64_t{height} * part / run);
}

}

void CoverageRow::add(Fixed top, Fixed bottom, std::int32_t height, std::int32_t sign)
{
    if (height == 0 || sign == 0)
        return;
    touch(std::min(top, bottom), std::max(top, bottom));
    add_touched(top, bottom, height, sign);
}

void CoverageRow::touch(Fixed left, Fixed right)
{
    const std::int32_t begin = std::max(to_column(left) >> column_bits, std::int32_t{0});
    const std::int32_t end =
        std::clamp(to_column(right) >> column_bits, std::int32_t{0}, std::int32_t{width_});
    if (begin < width_)
        touched_.add(begin, end + 2);
}

void CoverageRow::add_touched(Fixed top, Fixed bottom, std::int32_t height, std::int32_t sign)
{
    const std::int32_t from = to_column(top);
    const std::int32_t to = to_column(bottom);
    const auto is_in_row = [this](std::int32_t cell) {
        return static_cast<std::uint32_t>(cell) < static_cast<std::uint32_t>(width_);
    };
    const std::int32_t cell = from >> column_bits;
    const std::int32_t last = to >> column_bits;
    if (!is_in_row(cell) || !is_in_row(last))
        add_clipped(std::min(from, to), std::max(from, to), height, sign);
    else if (cell == last)
        deposit(cell, sign * height, (from & (columns - 1)) + (to & (columns - 1)));
    else if (height != 0)
        add_across(std::min(from, to), std::max(from, to), height, sign);
}

void CoverageRow::add_clipped(std::int32_t left, std::int32_t right, std::int32_t height, std::int32_t sign)
{
    const std::int32_t edge_of_row = width_ * columns;
    if (left >= edge_of_row)
        return;
    if (left < 0) {
        const std::int32_t outside = right <= 0 ? height : share_of(height, -left, right - left);
        deposit(0, sign * outside, 0);
        height -= outside;
        left = 0;
    }
    if (right > edge_of_row) {
        height = share_of(height, edge_of_row - left, right - left);
        right = edge_of_row;
    }
    if (height == 0)
        return;
    if (left >> column_bits == right >> column_bits)
        deposit(left >> column_bits, sign * height, (left & (columns - 1)) + (right & (columns - 1)));
    else
        add_across(left, right, height, sign);
}

/// The height is divided over the pixels by whole sub-rows, the remainder carried along: nothing is lost.
void CoverageRow::add_across(std::int32_t left, std::int32_t right, std::int32_t height, std::int32_t sign)
{
    const auto run = static_cast<std::uint32_t>(right - left);
    const std::int32_t last = right >> column_bits;
    std::int32_t cell = left >> column_bits;
    const std::int32_t before = left & (columns - 1);
    did(Work::flat_edge);
    did(Work::crossed_pixel, static_cast<std::uint32_t>(last - cell));
    const auto divided = [=](std::int32_t part) {
        const std::uint32_t product = static_cast<std::uint32_t>(height * part);
        const std::uint32_t quotient = product / run;
        return std::pair{static_cast<std::int32_t>(quotient), product - quotient * run};
    };
    auto [part, carry] = divided(columns - before);
    std::int32_t rest = height - part;
    deposit(cell, sign * part, before + columns);
    if (++cell < last) {
        const auto [each, each_carry] = divided(columns);
        for (; cell < last; ++cell) {
            carry += each_carry;
            part = each + (carry >= run ? 1 : 0);
            carry -= carry >= run ? run : 0;
            rest -= part;
            deposit(cell, sign * part, columns);
        }
    }
    deposit(last, sign * rest, right & (columns - 1));
}

/// `ends` is the sum of the columns within the pixel where the edge begins and ends.
void CoverageRow::deposit(std::int32_t cell, std::int32_t height, std::int32_t ends)
{
    cells_[cell] += height * (2 * columns - ends);
    cells_[cell + 1] += height * ends;
}

}

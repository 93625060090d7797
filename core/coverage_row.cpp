#include "core/coverage_row.hpp"

#include <algorithm>
#include <utility>

namespace kfast {
namespace {

constexpr int column_bits = 10;
constexpr std::int32_t columns = 1 << column_bits; ///< sub-columns of a pixel

std::int32_t to_column(Fixed x) { return (x.raw() + 32) >> 6; }

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
    const std::int32_t from = to_column(top);
    const std::int32_t to = to_column(bottom);
    const std::int32_t cell = from >> column_bits;
    if (cell == to >> column_bits && cell >= 0 && cell < width_) { // mostly
        touched_.add(cell, cell + 2);
        deposit(cell, sign * height, (from & (columns - 1)) + (to & (columns - 1)));
    } else {
        add_clipped(std::min(from, to), std::max(from, to), height, sign);
    }
}

void CoverageRow::add_clipped(std::int32_t left, std::int32_t right, std::int32_t height, std::int32_t sign)
{
    const std::int32_t edge_of_row = width_ * columns;
    if (left >= edge_of_row)
        return;
    if (left < 0) {
        const std::int32_t outside = right <= 0 ? height : share_of(height, -left, right - left);
        touched_.add(0, 2);
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
    touched_.add(left >> column_bits, (right >> column_bits) + 2);
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

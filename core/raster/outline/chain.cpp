#include "core/raster/outline/chain.hpp"

#include "core/raster/outline/grid.hpp"

#include <algorithm>
#include <cstdlib>

namespace kfast::raster {

namespace {

/// How far a corner may be from the line that replaces it, in the grid: horizontally, which is 1/26 of a
/// pixel's area at most ...
constexpr std::int32_t tolerance = 5;
/// ... and vertically, 1/21 of it.
constexpr std::int32_t flat_tolerance = 3;

/// Slopes of two edges that meet in a row which both of them leave differ by no more than this, in 1/65536,
/// if the corner is certainly within the tolerance: it is off by a quarter of what they differ, at most.
constexpr std::uint32_t slight_turn = 4 * tolerance * (65536 / grid);

constexpr std::int32_t no_slope = 0x7FFF'FFFF;

constexpr bool is_out_of_reach(std::int32_t x)
{
    return static_cast<std::uint32_t>(x) >> ChainBuilder::reach_bits != 0;
}

/// False if one of them is no_slope: it is further from any slope, also around the end of the range.
constexpr bool is_slight_turn(std::int32_t before, std::int32_t after)
{
    return static_cast<std::uint32_t>(after) - static_cast<std::uint32_t>(before) + slight_turn <=
           2 * slight_turn;
}

constexpr Bend bend(std::int32_t x, std::int32_t y)
{
    return {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)};
}

}

std::size_t ChainBuilder::room_for(std::size_t corners, std::int32_t top, std::int32_t bottom)
{
    return crossing_bytes(top, bottom) + (corners + 1) * sizeof(Bend);
}

bool ChainBuilder::build(const Corner* at, const Corner* last, std::ptrdiff_t step, std::int32_t left,
                         std::byte* end)
{
    begin(*at, *last, end);
    const std::int32_t first_y = at->y;
    const std::int32_t origin = first_y & -grid;
    Crossing* out = crossings_;
    std::int32_t x = at->x - left;
    std::int32_t y = at->y - origin;
    if (is_out_of_reach(x) || last->y - origin > max_height)
        return false;
    *out++ = static_cast<Crossing>(x);
    Bend above = bend(x, y);             // where the part of the chain in this row begins
    std::int32_t slope_above = no_slope; // of the edge that ends in the only corner of this row so far
    while (at != last) {
        at += step;
        const std::int32_t next_x = at->x - left;
        const std::int32_t next_y = at->y - origin;
        if (is_out_of_reach(next_x))
            return false;
        const std::int32_t to_border = grid - (y & (grid - 1));
        std::int32_t beyond = next_y - y - to_border;
        if (beyond < 0) {
            if (next_y == y && is_on_border(y) && out != crossings_ + 1) {
                keep_for_good(x, y); // a level edge between two rows: the one below begins after it
                out[-1] = static_cast<Crossing>(next_x);
                above = bend(next_x, y);
            } else if (at != last || at->y == first_y) {
                keep(next_x, next_y);
            }
            slope_above = no_slope;
        } else {
            const std::int32_t slope = slope_of(next_x - x, next_y - y);
            std::int32_t fine = first_crossing(x, slope, to_border);
            if (last_bend_ != row_bends_) {
                if (is_slight_turn(slope_above, slope))
                    last_bend_ = row_bends_;
                else
                    settle_row(above, bend(fine >> 10, y + to_border));
            }
            *out++ = static_cast<Crossing>(fine >> 10);
            while ((beyond -= grid) >= 0) {
                fine += slope;
                *out++ = static_cast<Crossing>(fine >> 10);
            }
            if (is_on_border(next_y)) {
                out[-1] = static_cast<Crossing>(next_x); // not as the slope has rounded it
                slope_above = no_slope;
            } else {
                if (at != last)
                    keep(next_x, next_y);
                slope_above = slope;
            }
            above = {out[-1], static_cast<std::uint16_t>(next_y & -grid)};
        }
        x = next_x;
        y = next_y;
    }
    if (!is_on_border(y)) {
        *out = static_cast<Crossing>(x);
        settle_row(above, bend(x, y));
    }
    *--last_bend_ = {0, Bend::no_y};
    return true;
}

void ChainBuilder::begin(Corner first, Corner last, std::byte* end)
{
    crossings_ = reinterpret_cast<Crossing*>(end - crossing_bytes(first.y, last.y));
    bends_ = last_bend_ = row_bends_ = reinterpret_cast<Bend*>(crossings_);
}

/// Drops the corners of a row if all of them are near the line from `from` to `to`.
void ChainBuilder::settle_row(Bend from, Bend to)
{
    const std::int32_t width = to.x - from.x;
    const std::int32_t rise = to.y - from.y;
    const std::int32_t limit = std::max(tolerance * rise, flat_tolerance * std::abs(width));
    bool are_near = true;
    for (const Bend* corner = last_bend_; corner != row_bends_; ++corner) {
        const std::int32_t off = (corner->x - from.x) * rise - (corner->y - from.y) * width;
        are_near = are_near && std::abs(off) <= limit;
    }
    if (are_near && rise != 0)
        last_bend_ = row_bends_;
    else
        row_bends_ = last_bend_;
}

}

#pragma once

#include "core/raster/outline/chain.hpp"
#include "core/raster/outline/grid.hpp"

#include <cstddef>
#include <cstdint>

namespace kfast::raster {

/// Turns corners that go down all the way into what is kept of a chain.
///
///     row border  ----x------------   crossing
///                      \               corner within 5/64 px of the line between both crossings: dropped
///                       ·
///     row border  -------x---------   crossing
///                         \____.       corners further away: kept as bends
///                               |
///     row border  --------------x--   crossing
///
/// So a row is drawn from two numbers, however many corners it has, unless it has bends.
class ChainBuilder {
public:
    /// Corners may be so far to the right of `left`, 512 px, and so far below the row of the first one.
    static constexpr int reach_bits = 15;
    static constexpr std::int32_t max_height = (0xFFFF >> grid_bits) * grid;

    /// The least room that a chain of `corners` corners from `top` to `bottom` needs, in bytes below the end
    /// that is given to build(): all of its corners may have to be kept.
    static std::size_t room_for(std::size_t corners, std::int32_t top, std::int32_t bottom);

    /// Of the crossings alone, in whole words.
    static constexpr std::uint32_t crossing_bytes(std::int32_t top, std::int32_t bottom)
    {
        return (static_cast<std::uint32_t>(ceil_pixel(bottom) - floor_pixel(top)) + 2) / 2 * 4;
    }

    /// Writes the crossings of `first`, `step` corners on, and so forth to `last`, and their bends, below
    /// `end`, which is aligned to 4. y grows from corner to corner, or stays as it is. False if a corner is
    /// out of reach.
    bool build(const Corner* first, const Corner* last, std::ptrdiff_t step, std::int32_t left,
               std::byte* end);

    const Crossing* crossings() const { return crossings_; }
    /// Behind the first one; the others follow downwards.
    const Bend* bends() const { return bends_; }
    /// What was written begins here, aligned to 4.
    std::byte* memory_begin() const { return reinterpret_cast<std::byte*>(last_bend_); }

private:
    void begin(Corner first, Corner last, std::byte* end);
    /// A corner within a row; it may be dropped when the row is settled.
    void keep(std::int32_t x, std::int32_t y)
    {
        *--last_bend_ = {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)};
    }
    void keep_for_good(std::int32_t x, std::int32_t y)
    {
        keep(x, y);
        row_bends_ = last_bend_;
    }
    void settle_row(Bend from, Bend to);

    Crossing* crossings_ = nullptr;
    Bend* bends_ = nullptr; ///< behind the first one, which is written below it
    Bend* last_bend_ = nullptr;
    Bend* row_bends_ = nullptr; ///< the last one of the rows above
};

}

#pragma once

#include "core/player.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace kfast::test {

/// For a SlowPanel. Fills every row with its number when the panel has to be drawn; then nothing changes any
/// more.
class NumberedRows {
public:
    void show_moment(Time moment) { shown.push_back(moment.ticks / Time::ticks_per_frame); }
    bool is_coarse() const { return are_coarse; }
    void redraw()
    {
        ++redraws;
        row_ = 0;
    }

    template <PixelFormat format>
    std::span<const Change> draw_changes(std::span<std::byte> pixels, Size granularity, int)
    {
        const int room = static_cast<int>(pixels.size()) / 3;
        const int rows = std::min(room - room % granularity.height, 10 - row_);
        if (rows == 0)
            return {};
        change_ = {{0, row_, 6, rows}, pixels.first(static_cast<std::size_t>(3 * rows))};
        for (int i = 0; i < 3 * rows; ++i)
            pixels[static_cast<std::size_t>(i)] = static_cast<std::byte>(row_ + i / 3);
        row_ += rows;
        return {&change_, 1};
    }

    std::vector<int> shown;
    int redraws = 0;
    bool are_coarse = false; ///< the pictures

private:
    int row_ = 0;
    Change change_;
};

/// What is shown then.
inline std::array<std::byte, 30> ten_numbered_rows()
{
    std::array<std::byte, 30> rows{};
    for (std::size_t i = 0; i < rows.size(); ++i)
        rows[i] = static_cast<std::byte>(i / 3);
    return rows;
}

}

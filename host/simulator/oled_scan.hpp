#pragma once

#include <optional>

namespace kfast {

/// Which row of an OLED controller's memory each line of the glass shows: the lines are scanned one after
/// another, beginning with the row `start`, from the first line on or from the last one.
struct OledScan {
    int memory_rows = 0;
    int lines = 0; ///< how many are scanned
    int start = 0;
    bool from_last = false;

    /// What line `line` shows; nothing if it is not scanned.
    constexpr std::optional<int> row_of(int line) const
    {
        const int step = from_last ? lines - 1 - line : line;
        if (step < 0 || step >= lines)
            return std::nullopt;
        return (start + step) % memory_rows;
    }

    /// Which line shows a row, perhaps one beyond those that are scanned.
    constexpr int line_of(int row) const
    {
        const int step = (row - start + memory_rows) % memory_rows;
        return from_last ? lines - 1 - step : step;
    }
};

}

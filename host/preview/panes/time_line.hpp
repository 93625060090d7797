#pragma once

#include "core/math/point.hpp"
#include "core/time/time.hpp"
#include "host/preview/playback/time_table.hpp"

#include <cstddef>
#include <optional>

namespace kfast {

/// Where the parts of a time line are in its pane. Used for drawing and for the mouse.
class TimeLine {
public:
    static constexpr int row_height = 18;
    static constexpr int lane_height = 20; ///< of clips, and of events
    static constexpr int ruler_height = 36;
    static constexpr int name_margin = 8; ///< left of the names

    /// The height for all of a table.
    static int wanted_height(const TimeTable& table);
    /// The part of it for rows that can be scrolled to instead: all but a few.
    static int spare_height(const TimeTable& table);

    /// `table` must outlive it. `first_row` is the topmost of those visible, as far as there are rows enough
    /// below it to fill the pane.
    TimeLine(const TimeTable& table, Rect pane, std::size_t first_row = 0);

    const TimeTable& table() const { return table_; }
    Rect pane() const { return pane_; }
    Rect ruler() const;
    /// No size where there are none, or no room for them.
    Rect clips() const;
    Rect events() const;
    /// All visible rows, with their names.
    Rect rows() const;
    /// One of the visible rows, from first_row() on.
    Rect row(std::size_t number) const;
    /// The column right of the names, with the times.
    Rect moments() const;

    std::size_t first_row() const { return first_row_; }
    /// The first row that is not visible any more.
    std::size_t end_row() const;
    /// The highest first_row.
    std::size_t last_first_row() const;

    /// The column of a time, within moments() for those of the scene.
    double x_of(Time moment) const;
    /// The nearest time of the scene.
    Time time_at(double x) const;

    std::optional<std::size_t> row_at(int x, int y) const;
    /// Where the triangle is that folds and unfolds a row, left of its name. Only for the visible rows.
    Rect triangle(std::size_t row) const;
    /// The time of a key of that row which is drawn there.
    std::optional<Time> key_at(std::size_t row, int x) const;

private:
    int rows_top() const;
    int seen_rows() const;

    const TimeTable& table_;
    Rect pane_;
    int names_width_;
    std::size_t first_row_;
};

}

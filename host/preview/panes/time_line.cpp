#include "host/preview/panes/time_line.hpp"

#include "host/preview/painter/painter.hpp"
#include "host/preview/painter/text_columns.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace kfast {
namespace {

constexpr int side_margin = 22; // of the times: room for half a number
constexpr int key_reach = 6;    // pixels from its middle
constexpr int triangle_columns = 2;

int lane_or_none(bool any) { return any ? TimeLine::lane_height : 0; }

/// As wide as the longest name, but no more than a third of the pane.
int names_width(const TimeTable& table, int pane)
{
    int columns = 7;
    for (const TimeRow& row : table.rows)
        columns = std::max(columns, triangle_columns + row.depth + columns_of(row.name));
    return std::min({(columns + 2) * Painter::letter.width, pane / 3, 180});
}

}

int TimeLine::wanted_height(const TimeTable& table)
{
    return ruler_height + lane_or_none(!table.clips.empty()) + lane_or_none(!table.events.empty()) +
           row_height * static_cast<int>(table.rows.size()) + 4;
}

int TimeLine::spare_height(const TimeTable& table)
{
    constexpr int few = 3;
    return row_height * std::max(0, static_cast<int>(table.rows.size()) - few);
}

TimeLine::TimeLine(const TimeTable& table, Rect pane, std::size_t first_row)
    : table_{table},
      pane_{pane},
      names_width_{names_width(table, pane.width)},
      first_row_{std::min(first_row, last_first_row())}
{
}

Rect TimeLine::ruler() const { return {pane_.x, pane_.y, pane_.width, std::min(ruler_height, pane_.height)}; }

Rect TimeLine::clips() const
{
    return common({pane_.x, bottom_of(ruler()), pane_.width, lane_or_none(!table_.clips.empty())}, pane_);
}

Rect TimeLine::events() const
{
    return common({pane_.x, bottom_of(clips()), pane_.width, lane_or_none(!table_.events.empty())}, pane_);
}

int TimeLine::rows_top() const
{
    return pane_.y + ruler_height + lane_or_none(!table_.clips.empty()) +
           lane_or_none(!table_.events.empty());
}

int TimeLine::seen_rows() const { return std::max(0, (bottom_of(pane_) - rows_top()) / row_height); }

std::size_t TimeLine::last_first_row() const
{
    const auto seen = static_cast<std::size_t>(seen_rows());
    return table_.rows.size() > seen ? table_.rows.size() - seen : 0;
}

std::size_t TimeLine::end_row() const
{
    return std::min(table_.rows.size(), first_row_ + static_cast<std::size_t>(seen_rows()));
}

Rect TimeLine::rows() const
{
    return {pane_.x, rows_top(), pane_.width, static_cast<int>(end_row() - first_row_) * row_height};
}

Rect TimeLine::row(std::size_t number) const
{
    const int place = static_cast<int>(number - first_row_);
    return {pane_.x, rows_top() + place * row_height, pane_.width, row_height};
}

Rect TimeLine::moments() const
{
    return {pane_.x + names_width_, pane_.y, pane_.width - names_width_, pane_.height};
}

double TimeLine::x_of(Time moment) const
{
    const Rect room = inset(moments(), side_margin, 0);
    return room.x + static_cast<double>(moment.ticks) / std::max(1, table_.end.ticks) * room.width;
}

Time TimeLine::time_at(double x) const
{
    const Rect room = inset(moments(), side_margin, 0);
    const double share = std::clamp((x - room.x) / std::max(1, room.width), 0.0, 1.0);
    return {static_cast<std::int32_t>(std::lround(share * table_.end.ticks))};
}

std::optional<std::size_t> TimeLine::row_at(int x, int y) const
{
    if (!contains(rows(), x, y))
        return std::nullopt;
    return first_row_ + static_cast<std::size_t>((y - rows_top()) / row_height);
}

Rect TimeLine::triangle(std::size_t number) const
{
    const Rect place = row(number);
    const int left = place.x + name_margin + table_.rows[number].depth * Painter::letter.width;
    return {left, place.y, triangle_columns * Painter::letter.width, place.height};
}

std::optional<Time> TimeLine::key_at(std::size_t row, int x) const
{
    const std::vector<Time>& keys = table_.rows[row].keys;
    const auto distance = [&](Time key) { return std::abs(x_of(key) - (x + 0.5)); };
    const auto nearest =
        std::min_element(keys.begin(), keys.end(), [&](Time a, Time b) { return distance(a) < distance(b); });
    if (nearest == keys.end() || distance(*nearest) > key_reach)
        return std::nullopt;
    return *nearest;
}

}

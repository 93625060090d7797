#include "host/preview/text_box.hpp"

#include "host/preview/area.hpp"
#include "host/preview/shapes.hpp"
#include "host/preview/text_columns.hpp"
#include "host/preview/theme.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace kfast {
namespace {

constexpr Size letter = Painter::letter;
constexpr int line_height = letter.height + 1;
constexpr int margin = 14; // within a box
constexpr int column_gap = 28;

/// A dark plate with an edge, as much of it as `room` holds.
Rect draw_plate(Painter& painter, Rect wanted, Rect room, Colour edge)
{
    const Rect box = common(wanted, room);
    const double radius = std::min({6.0, box.width / 2.0, box.height / 2.0});
    if (is_empty(box))
        return box;
    draw_round_rect(painter, box, radius, theme::shade);
    painter.fill({box.x, box.y, box.width, std::min(2, box.height)}, edge);
    return box;
}

int most_columns(std::span<const std::string> lines)
{
    int columns = 0;
    for (const std::string& line : lines)
        columns = std::max(columns, columns_of(line));
    return columns;
}

/// A grid of the rows, column by column.
struct HelpGrid {
    int columns;
    int rows;
    int column_width;

    int width() const { return columns * column_width + (columns - 1) * column_gap + 2 * margin; }
    int height() const { return rows * line_height + 2 * margin; }
};

HelpGrid help_grid(Rect room, std::span<const std::string> rows)
{
    const int count = static_cast<int>(rows.size());
    const int width = most_columns(rows) * letter.width;
    const HelpGrid tall{1, count, width};
    const HelpGrid wide{2, (count + 1) / 2, width};
    if (tall.height() <= room.height)
        return tall;
    return {2, wide.rows, std::min(width, (room.width - 2 * margin - column_gap) / 2)};
}

void draw_help_row(Painter& painter, int x, int y, int columns, const std::string& row)
{
    const std::size_t key = std::min(row.find(' '), row.size());
    const std::string shown = cut(row, columns);
    painter.text(x, y, shown, theme::text);
    painter.text(x, y, shown.substr(0, std::min(key, shown.size())), theme::key);
}

}

void draw_help(Painter& painter, Rect room, std::span<const std::string> rows)
{
    const HelpGrid grid = help_grid(room, rows);
    const Rect wanted{room.x + (room.width - grid.width()) / 2,
                      room.y + std::max(0, (room.height - grid.height()) / 2), grid.width(), grid.height()};
    const Rect box = draw_plate(painter, wanted, room, theme::accent);
    const Clipped within{painter, box};
    for (int i = 0; i < static_cast<int>(rows.size()); ++i)
        draw_help_row(painter, box.x + margin + i / grid.rows * (grid.column_width + column_gap),
                      box.y + margin + i % grid.rows * line_height, grid.column_width / letter.width,
                      rows[static_cast<std::size_t>(i)]);
}

namespace {

struct ColouredLine {
    std::string text;
    Colour colour;
};

std::vector<ColouredLine> error_lines(std::span<const std::string> lines, int columns)
{
    std::vector<ColouredLine> shown;
    for (const std::string& line : lines) {
        const bool is_error = shown.empty() || line.find("error: ") != std::string::npos;
        for (std::string& part : wrapped(line, columns))
            shown.push_back({std::move(part), is_error ? theme::bad : theme::text});
    }
    return shown;
}

}

void draw_errors(Painter& painter, Rect room, std::span<const std::string> lines)
{
    const Rect free = inset(room, std::min(10, room.width / 20), std::min(10, room.height / 20));
    const int most = std::max(1, (free.height - 2 * margin) / line_height);
    auto shown = error_lines(lines, std::max(1, (free.width - 2 * margin) / letter.width));
    if (static_cast<int>(shown.size()) > most) {
        shown.resize(static_cast<std::size_t>(most));
        shown.back() = {"…", theme::text};
    }
    const int height = static_cast<int>(shown.size()) * line_height + 2 * margin;
    const Rect box = draw_plate(painter, {free.x, free.y, free.width, height}, free, theme::bad);
    const Clipped within{painter, box};
    int y = box.y + margin;
    for (const ColouredLine& line : shown) {
        painter.text(box.x + margin, y, line.text, line.colour);
        y += line_height;
    }
}

namespace {

/// A plate for one line of text, which it draws.
Rect draw_lower_plate(Painter& painter, Rect room, const std::string& text, int extra_height)
{
    constexpr int padding = 7;
    constexpr int gap = 12; // below it
    const std::string shown = cut(text, (room.width - 2 * margin) / letter.width);
    const int width = std::max(columns_of(shown) * letter.width, extra_height > 0 ? 240 : 0) + 2 * margin;
    const int height = letter.height + 2 * padding + extra_height;
    const Rect box = draw_plate(
        painter, {room.x + (room.width - width) / 2, bottom_of(room) - gap - height, width, height}, room,
        theme::accent);
    const Clipped within{painter, box};
    painter.text(box.x + (box.width - columns_of(shown) * letter.width) / 2, box.y + padding + 1, shown,
                 theme::text);
    return box;
}

}

void draw_notice(Painter& painter, Rect room, const std::string& text)
{
    draw_lower_plate(painter, room, text, 0);
}

void draw_progress(Painter& painter, Rect room, const std::string& text, double share)
{
    constexpr int bar_height = 6;
    const Rect box = draw_lower_plate(painter, room, text, bar_height + 4);
    const Rect bar = inset({box.x, bottom_of(box) - bar_height - 8, box.width, bar_height}, margin, 0);
    painter.fill(bar, theme::track);
    painter.fill(
        {bar.x, bar.y, static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * bar.width)), bar.height},
        theme::accent);
}

}

#include "host/preview/panes/text_box.hpp"

#include "host/preview/painter/painter.hpp"
#include "host/preview/painter/text_columns.hpp"
#include "host/preview/panes/theme.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace kfast {

void draw_status(Painter& painter, Rect pane, std::string_view text, std::string_view hint)
{
    constexpr int margin = 8;
    constexpr int gap = 2; // columns
    constexpr Size letter = Painter::letter;
    const Clipped within{painter, pane};
    painter.fill(pane, theme::backdrop);
    painter.fill({pane.x, pane.y, pane.width, 1}, theme::border);
    const int y = pane.y + (pane.height - letter.height) / 2 + 1;
    const int columns = (pane.width - 2 * margin) / letter.width;
    const int hint_columns = columns_of(hint);
    if (columns_of(text) + gap + hint_columns <= columns)
        painter.text(right_of(pane) - margin - hint_columns * letter.width, y, hint, theme::text);
    painter.text(pane.x + margin, y, cut(text, columns), theme::quiet_text);
}

namespace {

constexpr Size letter = Painter::letter;
constexpr int line_height = letter.height + 1;
constexpr int margin = 14; // within a box

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

int max_columns(std::span<const std::string> lines)
{
    int columns = 0;
    for (const std::string& line : lines)
        columns = std::max(columns, columns_of(line));
    return columns;
}

}

Size help_cells(Rect room)
{
    return {(room.width - 2 * margin) / letter.width, (room.height - 2 * margin) / line_height};
}

void draw_help(Painter& painter, Rect room, const HelpPage& page)
{
    const Size size{page.cells.width * letter.width + 2 * margin,
                    page.cells.height * line_height + 2 * margin};
    const Rect box = draw_plate(painter,
                                {room.x + (room.width - size.width) / 2,
                                 room.y + (room.height - size.height) / 2, size.width, size.height},
                                room, theme::accent);
    const Clipped within{painter, box};
    for (const HelpLine& line : page.lines) {
        const int x = box.x + margin + line.column * letter.width;
        const int y = box.y + margin + line.row * line_height;
        painter.text(x, y, line.text, theme::text);
        painter.text(x, y, first_columns(line.text, line.key_columns), theme::key);
    }
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

Rect draw_errors(Painter& painter, Rect room, std::span<const std::string> lines)
{
    const Rect free = inset(room, std::min(10, room.width / 20), std::min(10, room.height / 20));
    const int max = std::max(1, (free.height - 2 * margin) / line_height);
    auto shown = error_lines(lines, std::max(1, (free.width - 2 * margin) / letter.width));
    if (static_cast<int>(shown.size()) > max) {
        shown.resize(static_cast<std::size_t>(max));
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
    return box;
}

namespace {

/// A plate for a text, with the text.
Rect draw_lower_plate(Painter& painter, Rect room, const std::string& text, int extra_height)
{
    constexpr int padding = 7;
    constexpr int gap = 12; // below it
    const std::vector<std::string> lines =
        wrapped(text, std::max(1, (room.width - 2 * margin) / letter.width));
    const int width = std::max(max_columns(lines) * letter.width, extra_height > 0 ? 240 : 0) + 2 * margin;
    const int height = static_cast<int>(lines.size()) * line_height + 2 * padding + extra_height;
    const Rect box = draw_plate(
        painter, {room.x + (room.width - width) / 2, bottom_of(room) - gap - height, width, height}, room,
        theme::accent);
    const Clipped within{painter, box};
    int y = box.y + padding + 1;
    for (const std::string& line : lines) {
        painter.text(box.x + (box.width - columns_of(line) * letter.width) / 2, y, line, theme::text);
        y += line_height;
    }
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

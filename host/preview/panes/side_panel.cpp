#include "host/preview/panes/side_panel.hpp"

#include "host/preview/painter/painter.hpp"
#include "host/preview/painter/text_columns.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kfast {
namespace {

constexpr Size letter = Painter::letter;
constexpr int line_height = letter.height + 1;
constexpr int margin = 14;
constexpr int heading_gap = 12;
constexpr int bar_height = 4;
constexpr int hang = 2; // columns: what is below a line is its end, or the next one

void draw_bar(Painter& painter, Rect room, double share)
{
    const int filled = static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * room.width));
    painter.fill({room.x, room.y, room.width, bar_height}, theme::track);
    painter.fill({room.x, room.y, filled, bar_height}, theme::accent);
}

}

void SidePanel::add_heading(std::string text)
{
    lines_.push_back({.text = std::move(text), .colour = theme::heading, .is_heading = true});
}

void SidePanel::add(std::string text, Colour colour)
{
    lines_.push_back({.text = std::move(text), .colour = colour});
}

void SidePanel::add_value(std::string name, std::string value, bool is_chosen, std::optional<double> bar)
{
    lines_.push_back({.text = std::move(name),
                      .value = std::move(value),
                      .colour = is_chosen ? theme::text : theme::quiet_text,
                      .bar = bar});
}

void SidePanel::add_link(std::string text)
{
    lines_.push_back({.text = std::move(text), .colour = theme::accent, .is_link = true});
}

/// Draws a line, and returns where the next one goes.
int SidePanel::draw(Painter& painter, const Line& line, Rect room) const
{
    const int columns = std::max(1, room.width / letter.width);
    const int value_columns =
        std::min(columns_of(line.value), std::max(columns / 2, columns - columns_of(line.text) - 1));
    if (value_columns > 0) {
        painter.text(room.x, room.y, cut(line.text, columns - value_columns - 1), line.colour);
        painter.text(right_of(room) - value_columns * letter.width, room.y, cut(line.value, value_columns),
                     theme::text);
    } else
        painter.text(room.x, room.y, line.text, line.colour);
    if (!line.bar)
        return room.y + line_height;
    draw_bar(painter, {room.x, room.y + line_height + 1, room.width, bar_height}, *line.bar);
    return room.y + line_height + bar_height + 6;
}

std::vector<SidePanel::Line> SidePanel::wrapped_lines(int columns) const
{
    std::vector<Line> lines;
    for (const Line& line : lines_) {
        if (!line.value.empty()) {
            lines.push_back(line);
            continue;
        }
        for (std::string& part : wrapped(line.text, columns, hang)) {
            lines.push_back(line);
            lines.back().text = std::move(part);
        }
    }
    return lines;
}

Rect SidePanel::draw(Painter& painter, Rect pane) const
{
    Rect link;
    if (is_empty(pane))
        return link;
    const Clipped within{painter, pane};
    painter.fill(pane, theme::surface);
    painter.fill({pane.x, pane.y, 1, pane.height}, theme::border);
    const Rect room = inset(pane, std::min(margin, pane.width / 8), 10);
    int y = room.y;
    for (const Line& line : wrapped_lines(std::max(1, room.width / letter.width))) {
        if (line.is_heading && y > room.y)
            y += heading_gap;
        if (y + letter.height > bottom_of(room)) {
            painter.text(room.x, bottom_of(pane) - letter.height, "…", theme::quiet_text);
            break;
        }
        const int next = draw(painter, line, {room.x, y, room.width, bottom_of(room) - y});
        if (line.is_link) {
            const int top = is_empty(link) ? y : link.y;
            link = {room.x, top, room.width, next - top};
            painter.fill({room.x, next - 2, columns_of(line.text) * letter.width, 1}, theme::accent);
        }
        y = next;
    }
    return link;
}

}

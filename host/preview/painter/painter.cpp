#include "host/preview/painter/painter.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace kfast {

namespace {

/// That many that the difference between chord and circle is not visible.
int sides_of(double radius) { return 12 + static_cast<int>(4 * std::sqrt(radius)); }

/// `begin` and `end` count quarters of a circle, clockwise from the right.
void add_arc(std::vector<WindowSpot>& corners, WindowSpot centre, double radius, double begin, double end)
{
    const int steps = sides_of(radius);
    for (int i = 0; i <= steps; ++i) {
        const double angle = (begin + (end - begin) * i / steps) * std::numbers::pi / 2;
        corners.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
    }
}

}

void draw_line(Painter& painter, WindowSpot from, WindowSpot to, double width, Colour colour)
{
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    if (length == 0)
        return;
    const double x = (to.y - from.y) / length * width / 2;
    const double y = (from.x - to.x) / length * width / 2;
    painter.polygon(std::array{WindowSpot{from.x + x, from.y + y}, WindowSpot{to.x + x, to.y + y},
                               WindowSpot{to.x - x, to.y - y}, WindowSpot{from.x - x, from.y - y}},
                    colour);
}

void draw_disc(Painter& painter, WindowSpot centre, double radius, Colour colour)
{
    std::vector<WindowSpot> corners;
    add_arc(corners, centre, radius, 0, 4);
    painter.polygon(corners, colour);
}

/// One direction around outside, the other one around inside.
void draw_ring(Painter& painter, WindowSpot centre, double inner, double outer, Colour colour)
{
    std::vector<WindowSpot> corners;
    add_arc(corners, centre, outer, 0, 4);
    add_arc(corners, centre, inner, 4, 0);
    painter.polygon(corners, colour);
}

void draw_diamond(Painter& painter, WindowSpot centre, double radius, Colour colour)
{
    painter.polygon(
        std::array{WindowSpot{centre.x - radius, centre.y}, WindowSpot{centre.x, centre.y - radius},
                   WindowSpot{centre.x + radius, centre.y}, WindowSpot{centre.x, centre.y + radius}},
        colour);
}

void draw_round_rect(Painter& painter, Rect area, double radius, Colour colour)
{
    const double left = area.x + radius;
    const double right = right_of(area) - radius;
    const double top = area.y + radius;
    const double bottom = bottom_of(area) - radius;
    std::vector<WindowSpot> corners;
    add_arc(corners, {right, bottom}, radius, 0, 1);
    add_arc(corners, {left, bottom}, radius, 1, 2);
    add_arc(corners, {left, top}, radius, 2, 3);
    add_arc(corners, {right, top}, radius, 3, 4);
    painter.polygon(corners, colour);
}

void draw_frame(Painter& painter, Rect area, Colour colour)
{
    painter.fill({area.x, area.y, area.width, 1}, colour);
    painter.fill({area.x, bottom_of(area) - 1, area.width, 1}, colour);
    painter.fill({area.x, area.y + 1, 1, area.height - 2}, colour);
    painter.fill({right_of(area) - 1, area.y + 1, 1, area.height - 2}, colour);
}

void fill_corners(Painter& painter, Rect square, Colour colour)
{
    const double radius = square.width / 2.0;
    const WindowSpot centre{square.x + radius, square.y + square.height / 2.0};
    for (int quarter = 0; quarter < 4; ++quarter) {
        const bool is_on_right = quarter == 0 || quarter == 3;
        const bool is_lower = quarter < 2;
        std::vector<WindowSpot> corners{{static_cast<double>(is_on_right ? right_of(square) : square.x),
                                         static_cast<double>(is_lower ? bottom_of(square) : square.y)}};
        add_arc(corners, centre, radius, quarter, quarter + 1);
        painter.polygon(corners, colour);
    }
}

}

#include "host/preview/panes/picture_pane.hpp"

#include "host/preview/controls/zoom_steps.hpp"
#include "host/preview/painter/painter.hpp"
#include "host/preview/painter/scaled_picture.hpp"
#include "host/preview/painter/text_columns.hpp"
#include "host/preview/panes/theme.hpp"

#include <algorithm>
#include <cmath>

namespace kfast {

namespace {

Rect fitting(Size panel, Rect pane, int margin)
{
    const Rect room = inset(pane, std::min(margin, pane.width / 4), std::min(margin, pane.height / 4));
    const Rect place = placement(panel, {std::max(1, room.width), std::max(1, room.height)});
    return {room.x + place.x, room.y + place.y, place.width, place.height};
}

double panned(double pan, int length, int room)
{
    const double max = std::max(0.0, (length - room) / 2.0);
    return std::clamp(pan, -max, max);
}

int begin_of(int pane, int room, int length, double pan)
{
    return pane + static_cast<int>(std::floor((room - length) / 2.0 + pan));
}

}

PictureLayout::PictureLayout(Size panel, Rect pane, int zoom, WindowSpot pan, int margin)
    : panel_{panel}, pane_{pane}
{
    rect_ = fitting(panel, pane, margin);
    fitting_scale_ = scale();
    if (zoom == 0)
        return;
    const int by = std::clamp(zoom, 1, largest_zoom);
    const Size size{panel.width * by, panel.height * by};
    pan_ = {panned(pan.x, size.width, pane.width), panned(pan.y, size.height, pane.height)};
    rect_ = {begin_of(pane.x, pane.width, size.width, pan_.x),
             begin_of(pane.y, pane.height, size.height, pan_.y), size.width, size.height};
}

double PictureLayout::scale() const
{
    return std::max(rect_.width / static_cast<double>(panel_.width),
                    rect_.height / static_cast<double>(panel_.height));
}

WindowSpot PictureLayout::window_spot(PanelSpot spot) const
{
    return {rect_.x + spot.x * rect_.width / panel_.width, rect_.y + spot.y * rect_.height / panel_.height};
}

PanelSpot PictureLayout::panel_spot(WindowSpot spot) const
{
    return {(spot.x - rect_.x) * panel_.width / rect_.width,
            (spot.y - rect_.y) * panel_.height / rect_.height};
}

int PictureLayout::next_zoom(bool larger) const
{
    const double here = scale();
    if (larger) {
        const int next = next_larger_zoom(here);
        return fitting_scale_ > here && fitting_scale_ <= next ? 0 : next;
    }
    if (here <= 1)
        return fitting_scale_ < 1 ? 0 : 1;
    const int next = next_smaller_zoom(here);
    return fitting_scale_ < here && fitting_scale_ >= next ? 0 : next;
}

WindowSpot PictureLayout::pan_for(int zoom, WindowSpot spot) const
{
    const PanelSpot fixed = panel_spot(spot);
    const auto pan = [zoom](double at, double on_panel, int begin, int room, int pixels) {
        return at - on_panel * zoom - begin - (room - pixels * zoom) / 2.0;
    };
    return {pan(spot.x, fixed.x, pane_.x, pane_.width, panel_.width),
            pan(spot.y, fixed.y, pane_.y, pane_.height, panel_.height)};
}

namespace {

constexpr int smallest_gridded = 8;
constexpr double bezel_share = 0.3; // of a module's margin: the black edge of the glass

Rect grown(Rect area, int by)
{
    return {area.x - by, area.y - by, area.width + 2 * by, area.height + 2 * by};
}

/// A hole with its copper around, in each corner of a module.
void draw_holes(Painter& painter, Rect module, int margin)
{
    const double ring = margin * 0.24;
    const double from_edge = margin * 0.4;
    for (const double x : {module.x + from_edge, right_of(module) - from_edge})
        for (const double y : {module.y + from_edge, bottom_of(module) - from_edge}) {
            draw_disc(painter, {x, y}, ring, theme::solder);
            draw_disc(painter, {x, y}, ring * 0.6, theme::backdrop);
        }
}

/// The row of pins below the glass.
void draw_pins(Painter& painter, Rect module, int margin)
{
    constexpr int pins = 8;
    const double pitch = std::min(margin * 0.6, module.width / 2.0 / pins);
    const WindowSpot middle = middle_of(module);
    for (int pin = 0; pin < pins; ++pin)
        draw_disc(painter, {middle.x + (pin - (pins - 1) / 2.0) * pitch, bottom_of(module) - margin * 0.3},
                  pitch * 0.28, theme::solder);
}

/// Drawn below the picture.
void draw_module(Painter& painter, Rect glass, int margin)
{
    const Rect module = grown(glass, margin - 4);
    draw_round_rect(painter, module, margin * 0.3, theme::module_edge);
    draw_round_rect(painter, inset(module, 1), margin * 0.3 - 1, theme::module);
    draw_holes(painter, module, margin);
    draw_pins(painter, module, margin);
    draw_round_rect(painter, grown(glass, static_cast<int>(margin * bezel_share)), 3, theme::glass);
}

/// Drawn above the picture, whose corners it hides.
void draw_round_edge(Painter& painter, Rect glass)
{
    fill_corners(painter, glass, theme::backdrop);
    draw_ring(painter, middle_of(glass), glass.width / 2.0 - 0.5, glass.width / 2.0 + 0.7, theme::border);
}

void draw_round_module(Painter& painter, Rect glass, int margin)
{
    const WindowSpot middle = middle_of(glass);
    const double radius = glass.width / 2.0;
    const double bezel = radius + margin * bezel_share;
    const double edge = radius + margin - 4;
    fill_corners(painter, glass, theme::backdrop);
    draw_ring(painter, middle, radius - 0.5, bezel, theme::glass);
    draw_ring(painter, middle, bezel - 0.5, edge, theme::module);
    draw_ring(painter, middle, edge - 1, edge, theme::module_edge);
}

void draw_grid(Painter& painter, const PictureLayout& place)
{
    const int step = static_cast<int>(place.scale());
    const Rect seen = common(place.rect(), place.pane());
    if (step < smallest_gridded)
        return;
    const auto first = [step](int begin, int from) {
        return begin + (from - begin + step - 1) / step * step;
    };
    for (int x = first(place.rect().x, seen.x); x < right_of(seen); x += step)
        painter.fill({x, seen.y, 1, seen.height}, theme::pixel_grid);
    for (int y = first(place.rect().y, seen.y); y < bottom_of(seen); y += step)
        painter.fill({seen.x, y, seen.width, 1}, theme::pixel_grid);
}

void draw_area(Painter& painter, const Overlay::Area& area, const PictureLayout& place)
{
    const Rect& panel = area.place;
    const WindowSpot from = place.window_spot({static_cast<double>(panel.x), static_cast<double>(panel.y)});
    const WindowSpot to =
        place.window_spot({static_cast<double>(right_of(panel)), static_cast<double>(bottom_of(panel))});
    const Rect shown{static_cast<int>(from.x), static_cast<int>(from.y),
                     static_cast<int>(to.x) - static_cast<int>(from.x),
                     static_cast<int>(to.y) - static_cast<int>(from.y)};
    painter.fill(shown, theme::faint(theme::mark(area.kind), 40));
    draw_frame(painter, shown, theme::mark(area.kind));
}

void draw_dark_edged_line(Painter& painter, WindowSpot from, WindowSpot to, double width, Colour colour)
{
    draw_line(painter, from, to, width + 2, theme::faint(theme::glass, 150));
    draw_line(painter, from, to, width, colour);
}

void draw_line(Painter& painter, const Overlay::Line& line, const PictureLayout& place)
{
    const double width = line.kind == MarkKind::bone || line.kind == MarkKind::backbone ? 2.5 : 1.4;
    draw_dark_edged_line(painter, place.window_spot(line.from), place.window_spot(line.to), width,
                         theme::mark(line.kind));
}

void draw_dot(Painter& painter, const Overlay::Dot& dot, const PictureLayout& place)
{
    const WindowSpot at = place.window_spot(dot.at);
    const double radius = dot.kind == MarkKind::bone || dot.kind == MarkKind::backbone ? 4 : 3;
    draw_disc(painter, at, radius + 1, theme::faint(theme::glass, 190));
    draw_disc(painter, at, radius, theme::mark(dot.kind));
}

void draw_label(Painter& painter, const Overlay::Label& label, const PictureLayout& place)
{
    constexpr Size letter = Painter::letter;
    constexpr int away = 5; // from the dot that it belongs to
    const WindowSpot at = place.window_spot(label.at);
    const int x = static_cast<int>(at.x) + away;
    const int y = static_cast<int>(at.y) - letter.height;
    painter.fill({x - 1, y + 1, columns_of(label.text) * letter.width + 2, letter.height - 2},
                 theme::faint(theme::glass, 170));
    painter.text(x, y, label.text, theme::mark(label.kind));
}

}

int module_margin(Rect pane) { return std::clamp(std::min(pane.width, pane.height) / 18, 12, 30); }

void draw_picture(Painter& painter, const Picture& picture, const PictureLayout& place,
                  const PictureLook& look)
{
    const Clipped within{painter, place.pane()};
    const int margin = module_margin(place.pane());
    painter.fill(place.pane(), theme::backdrop);
    if (look.has_module && !look.is_round)
        draw_module(painter, place.rect(), margin);
    else if (!look.is_round)
        draw_frame(painter, grown(place.rect(), 1), theme::border);
    painter.picture(picture, place.rect());
    draw_grid(painter, place);
    if (look.has_module && look.is_round)
        draw_round_module(painter, place.rect(), margin);
    else if (look.is_round)
        draw_round_edge(painter, place.rect());
}

void draw_overlay(Painter& painter, const Overlay& overlay, const PictureLayout& place)
{
    const Clipped within{painter, place.pane()};
    for (const Overlay::Area& area : overlay.areas)
        draw_area(painter, area, place);
    for (const Overlay::Line& line : overlay.lines)
        draw_line(painter, line, place);
    for (const Overlay::Dot& dot : overlay.dots)
        draw_dot(painter, dot, place);
    for (const Overlay::Label& label : overlay.labels)
        draw_label(painter, label, place);
}

}

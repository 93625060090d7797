#include "host/preview/window/preview_screen.hpp"

#include "host/preview/painter/painter.hpp"
#include "host/preview/panes/picture_pane.hpp"
#include "host/preview/panes/text_box.hpp"
#include "host/preview/panes/time_line_pane.hpp"
#include "host/preview/viewer/beside.hpp"
#include "host/preview/window/side_contents.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace kfast {
namespace {

constexpr PreviewScreen::Seconds notice_stays{4};
constexpr int click_reach = 3; // pixels that a hand may shake

int margin(const ViewOptions& view, Rect pane)
{
    constexpr int default_margin = 12;
    return view.panel_frame ? module_margin(pane) : default_margin;
}

Rect above_status(const WindowLayout& layout) { return {0, 0, layout.status.width, layout.status.y}; }

WindowSpot spot_of(const PointerEvent& event) { return {event.x + 0.5, event.y + 0.5}; }

/// The frame at a time, or the end where that is between frames.
Time nearest_frame(Time moment, Time end)
{
    constexpr std::int32_t frame = Time::ticks_per_frame;
    return std::min(Time::frame((moment.ticks + frame / 2) / frame), end);
}

}

// The layout.

WindowLayout PreviewScreen::layout(Viewer& viewer) const
{
    const ViewOptions& view = viewer.view();
    const TimeTable& table = viewer.unfolded_table();
    const bool has_beside = viewer.scene().beside != nullptr;
    return window_layout(window_, {.side = !has_beside,
                                   .side_at_any_width = view.fit_report,
                                   .beside = has_beside,
                                   .time_line_height = view.time_line ? TimeLine::wanted_height(table) : 0,
                                   .spare_time_line_height = TimeLine::spare_height(table),
                                   .panel = viewer.scene().panel,
                                   .picture_margin = margin(view, {0, 0, window_.width, window_.height})});
}

PictureLayout PreviewScreen::place(const Viewer& viewer, Rect pane) const
{
    const ViewOptions& view = viewer.view();
    return {viewer.scene().panel, pane, view.zoom, pan_, margin(view, pane)};
}

TimeLine PreviewScreen::time_line(Viewer& viewer, Rect pane) const
{
    return {viewer.unfolded_table(), pane, first_row_};
}

// Drawing.

void PreviewScreen::draw(Painter& painter, Viewer& viewer, Seconds now)
{
    window_ = painter.size();
    const WindowLayout parts = layout(viewer);
    const std::string facts = draw_picture_pane(painter, viewer, parts.picture);
    draw_beside(painter, viewer, parts);
    link_ = side_contents(viewer, place(viewer, parts.picture).scale()).draw(painter, parts.side);
    draw_time_line(painter, time_line(viewer, parts.time_line),
                   {.now = viewer.playback().time(),
                    .frame_rate = viewer.scene().playback_setup.frame_rate,
                    .selected = viewer.view().selected,
                    .clip = viewer.playback().part().name});
    draw_status(painter, parts.status, (facts.empty() ? "" : facts + "  ") + viewer.status(),
                viewer.playback().help_open() ? "" : help_hint);
    draw_help_and_errors(painter, viewer, parts);
    draw_messages(painter, viewer, parts.picture, now);
}

/// The help below the errors.
void PreviewScreen::draw_help_and_errors(Painter& painter, const Viewer& viewer, const WindowLayout& parts)
{
    const bool has_help = viewer.playback().help_open();
    Rect help_room = above_status(parts);
    if (!viewer.errors().empty()) {
        Rect room = parts.picture;
        room.height /= has_help ? 2 : 1;
        const int end = bottom_of(draw_errors(painter, room, viewer.errors()));
        help_room = {help_room.x, end, help_room.width, std::max(0, bottom_of(help_room) - end)};
    }
    if (has_help)
        draw_help(painter, help_room, help_.page(help_cells(help_room)));
}

std::string PreviewScreen::draw_picture_pane(Painter& painter, Viewer& viewer, Rect pane) const
{
    const PictureLayout shown = place(viewer, pane);
    draw_picture(painter, viewer.picture(), shown,
                 {.is_round = viewer.scene().is_round, .has_module = viewer.view().panel_frame});
    const Overlay& overlay = viewer.overlay(shown.scale());
    draw_overlay(painter, overlay, shown);
    return overlay.facts;
}

void PreviewScreen::draw_beside(Painter& painter, Viewer& viewer, const WindowLayout& parts) const
{
    const auto other = beside(viewer);
    if (!other)
        return;
    draw_picture(painter, other->picture, place(viewer, parts.beside),
                 {.has_module = viewer.view().panel_frame});
    draw_caption(painter, parts.picture, this_computer);
    draw_caption(painter, parts.beside, other->caption);
}

void PreviewScreen::draw_messages(Painter& painter, Viewer& viewer, Rect room, Seconds now)
{
    if (viewer.notice_number() != notice_number_) {
        notice_number_ = viewer.notice_number();
        notice_since_ = now;
    }
    shows_notice_ = !viewer.notice().empty() && now < notice_since_ + notice_stays;
    if (const auto share = viewer.progress())
        draw_progress(painter, room, viewer.notice(), *share);
    else if (shows_notice_)
        draw_notice(painter, room, viewer.notice());
}

bool PreviewScreen::is_outdated(Seconds now) const
{
    return shows_notice_ && now >= notice_since_ + notice_stays;
}

// Keys and the mouse.

void PreviewScreen::press(PreviewKey key, Viewer& viewer, Seconds now)
{
    const bool zooms = key == PreviewKey::zoom_in || key == PreviewKey::zoom_out;
    if (zooms && !viewer.is_working())
        return zoom(viewer, key == PreviewKey::zoom_in, middle_of(layout(viewer).picture));
    if (!help_.turns(key, viewer.playback().help_open() && !viewer.is_working()))
        viewer.press(key, now);
}

void PreviewScreen::zoom(Viewer& viewer, bool larger, WindowSpot around)
{
    const PictureLayout before = place(viewer, layout(viewer).picture);
    const int next = before.next_zoom(larger);
    pan_ = next == 0 ? WindowSpot{} : before.pan_for(next, around);
    viewer.set_zoom(next);
    pan_ = place(viewer, layout(viewer).picture).pan();
}

void PreviewScreen::touch(const PointerEvent& event, Viewer& viewer, Seconds now)
{
    if (event.button != PointerEvent::Button::left)
        return;
    switch (event.kind) {
    case PointerEvent::Kind::press:
        return begin_drag(event, viewer, now);
    case PointerEvent::Kind::move:
        return go_on_dragging(event, viewer);
    case PointerEvent::Kind::release:
        return end_drag(event, viewer);
    case PointerEvent::Kind::wheel:
        return turn_wheel(event, viewer);
    }
}

void PreviewScreen::begin_drag(const PointerEvent& event, Viewer& viewer, Seconds now)
{
    if (viewer.playback().help_open() || viewer.is_working())
        return press(PreviewKey::leave, viewer, now);
    const WindowLayout parts = layout(viewer);
    pressed_ = event;
    pan_at_press_ = pan_;
    is_click_ = true;
    if (contains(parts.picture, event.x, event.y))
        drag_ = Drag::picture;
    else if (contains(parts.time_line, event.x, event.y))
        touch_time_line(event, viewer, time_line(viewer, parts.time_line));
    else if (contains(link_, event.x, event.y))
        viewer.edit();
}

void PreviewScreen::touch_time_line(const PointerEvent& event, Viewer& viewer, const TimeLine& line)
{
    const auto row = line.row_at(event.x, event.y);
    const bool is_in_time = contains(line.moments(), event.x, event.y);
    if (row && line.table().rows[*row].can_unfold() && contains(line.triangle(*row), event.x, event.y)) {
        viewer.fold(line.table().rows[*row].item);
    } else if (row) {
        viewer.select(line.table().rows[*row].item);
        drag_ = Drag::row;
        if (const auto key = line.key_at(*row, event.x); is_in_time && key)
            viewer.scrub(*key);
    } else if (is_in_time) {
        drag_ = Drag::moment;
        go_on_dragging(event, viewer);
    }
}

void PreviewScreen::go_on_dragging(const PointerEvent& event, Viewer& viewer)
{
    const int right = event.x - pressed_.x;
    const int down = event.y - pressed_.y;
    is_click_ = is_click_ && std::abs(right) <= click_reach && std::abs(down) <= click_reach;
    if (drag_ == Drag::picture && !is_click_) {
        pan_ = {pan_at_press_.x + right, pan_at_press_.y + down};
        pan_ = place(viewer, layout(viewer).picture).pan();
    }
    if (drag_ == Drag::moment || (drag_ == Drag::row && !is_click_)) {
        const TimeLine line = time_line(viewer, layout(viewer).time_line);
        viewer.scrub(nearest_frame(line.time_at(event.x + 0.5), line.table().end));
    }
}

void PreviewScreen::end_drag(const PointerEvent& event, Viewer& viewer)
{
    if (drag_ == Drag::picture && is_click_) {
        const PictureLayout shown = place(viewer, layout(viewer).picture);
        viewer.select(viewer.item_at(shown.panel_spot(spot_of(event))));
    }
    drag_ = Drag::none;
}

void PreviewScreen::turn_wheel(const PointerEvent& event, Viewer& viewer)
{
    const WindowLayout parts = layout(viewer);
    if (event.wheel == 0 || viewer.is_working())
        return;
    if (contains(parts.picture, event.x, event.y))
        return zoom(viewer, event.wheel > 0, spot_of(event));
    if (!contains(parts.time_line, event.x, event.y))
        return;
    const auto max = static_cast<std::ptrdiff_t>(time_line(viewer, parts.time_line).last_first_row());
    first_row_ = static_cast<std::size_t>(
        std::clamp(static_cast<std::ptrdiff_t>(first_row_) - event.wheel, std::ptrdiff_t{0}, max));
}

}

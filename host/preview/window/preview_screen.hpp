#pragma once

#include "host/preview/controls/help_pages.hpp"
#include "host/preview/painter/painter.hpp"
#include "host/preview/panes/picture_pane.hpp"
#include "host/preview/panes/time_line.hpp"
#include "host/preview/viewer/viewer.hpp"
#include "host/preview/window/picture_window.hpp"
#include "host/preview/window/window_layout.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace kfast {

/// What the window of a preview looks like, and what its keys and its mouse do there. It keeps what belongs
/// to the window alone: where the picture was dragged to, and which rows of the time line are visible.
class PreviewScreen {
public:
    using Seconds = Viewer::Seconds;

    void draw(Painter& painter, Viewer& viewer, Seconds now);
    /// Keys that zoom start from what is visible, and the key of the help changes its pages; the rest is the
    /// viewer's.
    void press(PreviewKey key, Viewer& viewer, Seconds now);
    void touch(const PointerEvent& event, Viewer& viewer, Seconds now);
    /// Whether the last drawing shows something that disappears by itself.
    bool is_outdated(Seconds now) const;

private:
    enum class Drag : std::uint8_t { none, picture, moment, row };

    WindowLayout layout(Viewer& viewer) const;
    PictureLayout place(const Viewer& viewer, Rect pane) const;
    TimeLine time_line(Viewer& viewer, Rect pane) const;

    /// Returns the facts of its overlay.
    std::string draw_picture_pane(Painter& painter, Viewer& viewer, Rect pane) const;
    void draw_beside(Painter& painter, Viewer& viewer, const WindowLayout& parts) const;
    void draw_help_and_errors(Painter& painter, const Viewer& viewer, const WindowLayout& parts);
    void draw_messages(Painter& painter, Viewer& viewer, Rect room, Seconds now);

    void begin_drag(const PointerEvent& event, Viewer& viewer, Seconds now);
    void go_on_dragging(const PointerEvent& event, Viewer& viewer);
    void end_drag(const PointerEvent& event, Viewer& viewer);
    void touch_time_line(const PointerEvent& event, Viewer& viewer, const TimeLine& line);
    void turn_wheel(const PointerEvent& event, Viewer& viewer);
    void zoom(Viewer& viewer, bool larger, WindowSpot around);

    Size window_{1, 1}; ///< when it was drawn last
    WindowSpot pan_;
    std::size_t first_row_ = 0;
    Drag drag_ = Drag::none;
    PointerEvent pressed_; ///< where the drag began
    WindowSpot pan_at_press_;
    bool is_click_ = false; ///< not moved since it was pressed
    Rect link_;             ///< at the side, when it was drawn last: opens the editor
    OpenHelp help_{preview_help(PreviewFront::window)};
    std::uint64_t notice_number_ = 0; ///< of the one that was seen last
    Seconds notice_since_{};
    bool shows_notice_ = false;
};

}

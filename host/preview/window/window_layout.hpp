#pragma once

#include "core/math/point.hpp"

namespace kfast {

/// Where the parts of a window are. They do not overlap and cover all of it; a part that is not shown has no
/// size.
struct WindowLayout {
    Rect picture;
    Rect beside; ///< right of it, for the picture of another panel: as large
    Rect side;   ///< right of the picture
    Rect time_line;
    Rect status;
};

/// What a window should show besides the picture, if there is room.
struct WindowWishes {
    bool side = false; ///< if there is room beside the picture
    bool side_at_any_width = false;
    bool beside = false;
    int time_line_height = 0;       ///< it gets two fifths of the height at most
    int spare_time_line_height = 0; ///< of that: what it gives up if the picture is larger then
    Size panel{1, 1};               ///< whose picture is shown
    int picture_margin = 0;         ///< at each of its sides
};

/// The window in which a picture of that size, and the status alone, have room.
Size window_around(Size picture);

WindowLayout window_layout(Size window, const WindowWishes& wishes);

}

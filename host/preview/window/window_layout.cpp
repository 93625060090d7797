#include "host/preview/window/window_layout.hpp"

#include "host/preview/painter/painter.hpp"
#include "host/preview/painter/scaled_picture.hpp"

#include <algorithm>

namespace kfast {
namespace {

constexpr int status_height = Painter::letter.height + 8;
constexpr int roomy_width = 620; // of a window in which a side panel leaves enough to the picture

int side_width(Size window, const WindowWishes& wishes)
{
    if (!wishes.side_at_any_width && (!wishes.side || window.width < roomy_width))
        return 0;
    return std::min(window.width / 2, std::clamp(window.width * 3 / 10, 200, 340));
}

/// The height of a picture as large as fits, with its margins.
int picture_height(Size room, const WindowWishes& wishes)
{
    const int margins = 2 * wishes.picture_margin;
    const Size free{std::max(1, room.width - margins), std::max(1, room.height - margins)};
    return placement(wishes.panel, free).height + margins;
}

int time_line_height(Size above, const WindowWishes& wishes)
{
    const int max = std::clamp(wishes.time_line_height, 0, above.height * 2 / 5);
    const int min = std::clamp(wishes.time_line_height - wishes.spare_time_line_height, 0, max);
    const int left = above.height - picture_height({above.width, above.height - min}, wishes);
    return std::clamp(left, min, max);
}

}

Size window_around(Size picture) { return {picture.width, picture.height + status_height}; }

WindowLayout window_layout(Size window, const WindowWishes& wishes)
{
    const int status = std::min(status_height, window.height);
    const int above = window.height - status;
    const int side = side_width(window, wishes);
    const int pictures = window.width - side;
    const int across = wishes.beside ? pictures / 2 : pictures;
    const int time_line = time_line_height({across, above}, wishes);
    const int upper = above - time_line;
    return {.picture = {0, 0, across, upper},
            .beside = {across, 0, pictures - across, upper},
            .side = {window.width - side, 0, side, upper},
            .time_line = {0, upper, window.width, time_line},
            .status = {0, above, window.width, status}};
}

}

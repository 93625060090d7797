#include "host/preview/panes/picture_place.hpp"

#include "host/preview/controls/zoom_steps.hpp"
#include "host/preview/painter/area.hpp"
#include "host/preview/painter/placement.hpp"

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

PicturePlace::PicturePlace(Size panel, Rect pane, int zoom, WindowSpot pan, int margin)
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

double PicturePlace::scale() const
{
    return std::max(rect_.width / static_cast<double>(panel_.width),
                    rect_.height / static_cast<double>(panel_.height));
}

WindowSpot PicturePlace::window_spot(PanelSpot spot) const
{
    return {rect_.x + spot.x * rect_.width / panel_.width, rect_.y + spot.y * rect_.height / panel_.height};
}

PanelSpot PicturePlace::panel_spot(WindowSpot spot) const
{
    return {(spot.x - rect_.x) * panel_.width / rect_.width,
            (spot.y - rect_.y) * panel_.height / rect_.height};
}

int PicturePlace::next_zoom(bool larger) const
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

WindowSpot PicturePlace::pan_for(int zoom, WindowSpot spot) const
{
    const PanelSpot fixed = panel_spot(spot);
    const auto pan = [zoom](double at, double on_panel, int begin, int room, int pixels) {
        return at - on_panel * zoom - begin - (room - pixels * zoom) / 2.0;
    };
    return {pan(spot.x, fixed.x, pane_.x, pane_.width, panel_.width),
            pan(spot.y, fixed.y, pane_.y, pane_.height, panel_.height)};
}

}

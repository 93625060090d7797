#pragma once

#include "host/preview/overlay/overlay.hpp"
#include "host/preview/panes/picture_place.hpp"

namespace kfast {

/// How a picture is shown besides its pixels.
struct PictureLook {
    bool is_round = false;   ///< its corners are not seen
    bool has_module = false; ///< with the edge of the display's module around
};

/// Pixels of the window that the edge of a module takes on each side of a picture that fits a pane.
int module_margin(Rect pane);

/// Fills the pane, with an edge around the picture. From 8 pixels for each pixel of the panel on a grid tells
/// them apart.
void draw_picture(Painter& painter, const Picture& picture, const PicturePlace& place,
                  const PictureLook& look);

/// Bones, points and numbers above the picture.
void draw_overlay(Painter& painter, const Overlay& overlay, const PicturePlace& place);

}

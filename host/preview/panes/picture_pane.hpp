#pragma once

#include "host/preview/overlay/overlay.hpp"
#include "host/preview/painter/painter.hpp"

namespace kfast {

/// Where the picture of a panel is in a pane of the window, and how large; the pane may show a part of it.
class PictureLayout {
public:
    /// `zoom` window pixels for each pixel of the panel; 0: as large as fits whole, with `margin` pixels of
    /// the window left on each side. What is smaller than the pane is centred; the rest is moved by `pan`
    /// out of the middle, but not away from the pane.
    PictureLayout(Size panel, Rect pane, int zoom, WindowSpot pan = {}, int margin = 0);

    Rect rect() const { return rect_; }
    Rect pane() const { return pane_; }
    /// Window pixels for a pixel of the panel; below 1 where it is shrunk.
    double scale() const;
    /// The part of the offset from the middle that was possible.
    WindowSpot pan() const { return pan_; }

    WindowSpot window_spot(PanelSpot spot) const;
    PanelSpot panel_spot(WindowSpot spot) const;

    /// The next larger or smaller useful zoom, at least 1; 0 if that shows the picture as large
    /// as fits.
    int next_zoom(bool larger) const;
    /// The offset from the middle with which, at another zoom of at least 1, the point under `spot` stays.
    WindowSpot pan_for(int zoom, WindowSpot spot) const;

private:
    Size panel_;
    Rect pane_;
    Rect rect_;
    double fitting_scale_;
    WindowSpot pan_;
};

/// How a picture is shown besides its pixels.
struct PictureLook {
    bool is_round = false;   ///< its corners are not visible
    bool has_module = false; ///< with the edge of the display's module around
};

/// Pixels of the window that the edge of a module takes on each side of a picture that fits a pane.
int module_margin(Rect pane);

/// Fills the pane, with an edge around the picture. From 8 pixels for each pixel of the panel on a grid
/// separates them.
void draw_picture(Painter& painter, const Picture& picture, const PictureLayout& place,
                  const PictureLook& look);

/// Bones, points and numbers above the picture.
void draw_overlay(Painter& painter, const Overlay& overlay, const PictureLayout& place);

}

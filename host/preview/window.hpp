#pragma once

#include "host/preview/picture_window.hpp"
#include "host/preview/viewer.hpp"

namespace kfast {

/// A window with room for the picture of that panel, magnified if it is small, and for all that is beside it.
Size preview_window_size(Size panel);

/// Plays in a window until the user closes it or it has played as often as it was to.
void play_in_window(PictureWindow& window, Viewer& viewer);

}

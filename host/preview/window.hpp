#pragma once

#include "host/preview/viewer/viewer.hpp"
#include "host/preview/window/picture_window.hpp"

namespace kfast {

/// Room for the picture of usual panels twice as large, with all that is beside it.
Size first_window_size(Size panel);

/// Plays in a window until the user closes it or it has played as often as it was to.
void play_in_window(PictureWindow& window, Viewer& viewer);

}

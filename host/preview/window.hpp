#pragma once

#include "host/preview/viewer/viewer.hpp"
#include "host/preview/window/picture_window.hpp"

namespace kfast {

/// Room for the picture of common panels twice as large, with everything beside it.
Size first_window_size(Size panel);

/// Plays in a window until the user closes it or it has played as often as requested.
void play_in_window(PictureWindow& window, Viewer& viewer);

}

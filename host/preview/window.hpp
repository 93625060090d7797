#pragma once

#include "host/picture/frame_source.hpp"
#include "host/preview/playback.hpp"

#include <string>

namespace kfast {

/// Plays a scene in a window until the user closes it or it has played `loops` times. Returns false at once
/// where there can be no window (PictureWindow::no_window).
bool play_in_window(FrameSource& source, const Programme& programme, const std::string& title,
                    std::optional<int> loops);

}

#pragma once

#include "host/picture/frame_source.hpp"
#include "host/preview/playback.hpp"

#include <string>

namespace kfast {

/// Plays a scene in a window until the user closes it or it has played `loops` times. Returns false at once
/// where there is no display.
bool play_in_window(FrameSource& source, const Programme& programme, const std::string& title,
                    std::optional<int> loops);

}

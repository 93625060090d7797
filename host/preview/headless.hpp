#pragma once

#include "host/picture/frame_source.hpp"
#include "host/preview/playback.hpp"

#include <ostream>
#include <span>

namespace kfast {

/// Plays every frame of one pass once on a clock of its own, through the same state as a window, and writes
/// the events that it passes, "event 12.5 step" (at frame 12.5), then "60 frames, hash 1a2b3c4d" (CRC-32 over
/// the pixels of all of them).
void play_headless(FrameSource& source, const Programme& programme, std::ostream& out);

/// Presses `script` one after another, a frame of time apart, and writes the events passed and what is shown
/// after each, then the summary of these pictures. Stops at a quit.
void play_script(FrameSource& source, const Programme& programme, std::span<const PreviewKey> script,
                 std::ostream& out);

}

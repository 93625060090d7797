#pragma once

#include "host/picture/frame_source.hpp"
#include "host/preview/playback.hpp"

#include <ostream>
#include <span>

namespace kfast {

/// Plays every frame once on a clock of its own, through the same state as a window, and writes
/// "60 frames, hash 1a2b3c4d" (CRC-32 over the pixels of all of them).
void play_headless(FrameSource& source, const Timeline& timeline, const std::vector<Time>& keys,
                   std::ostream& out);

/// Presses `script` one after another, a frame of time apart, and writes what is shown after each, then the
/// summary of these pictures. Stops at a quit.
void play_script(FrameSource& source, const Timeline& timeline, const std::vector<Time>& keys,
                 std::span<const PreviewKey> script, std::ostream& out);

}

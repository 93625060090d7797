#pragma once

#include "host/picture/frame_source.hpp"
#include "host/preview/playback.hpp"

namespace kfast {

/// Plays `loops` passes (a scene that plays once: one) on the terminal behind standard output, as large as
/// fits, and leaves the last picture there. The cursor comes back at the end, on an error and on Ctrl-C.
/// Where standard input is a terminal too, it has the keys of the window.
///
/// Where standard output is no terminal, writes the first picture for 80 x 24 characters and returns.
///
/// True colour where COLORTERM says so, else 256 colours.
void play_in_terminal(FrameSource& source, const Programme& programme, int loops);

}

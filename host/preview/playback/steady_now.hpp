#pragma once

#include "host/preview/playback/preview_playback.hpp"

namespace kfast {

/// The clock of a preview that somebody watches.
inline PreviewPlayback::Seconds steady_now() { return std::chrono::steady_clock::now().time_since_epoch(); }

}

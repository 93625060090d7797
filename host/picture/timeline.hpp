#pragma once

#include "core/playhead.hpp"

#include <string>

namespace kfast {

/// What is played of a scene and how fast, and which frames that has: 0 ... L-1, for `once` also L, its end.
/// "Ticks" are those of the scene's time since playing began: 1024 for a frame, whatever the speed.
struct Timeline {
    std::uint32_t frame_rate = 30000; ///< frames in 1000 seconds
    PlayRange stretch{Time{0}, Time::frame(1), Loop::repeat};
    std::int32_t speed = Playhead::as_authored; ///< as Playhead's, not 0

    /// Set to where playing begins: backwards at the end.
    Playhead playhead(EventCursor events = EventCursor{ByteReader{}}) const;
    /// The number of frames of one pass, from one end to the other.
    int frame_count() const;
    /// The end of `once` may be between frames: its last frame is at exactly L.
    Time frame_time(int frame) const;
    /// The ticks until everything begins again, for ping-pong there and back; rounded up.
    std::int64_t period_ticks() const;
    Time shown_at(std::int64_t ticks) const;
    double seconds(std::int64_t ticks) const;
};

Timeline timeline_of(const SceneView& scene);

/// The number as it is in names of files, "0012".
std::string frame_digits(int frame);

}

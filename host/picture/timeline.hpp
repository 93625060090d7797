#pragma once

#include "core/scene_view.hpp"

namespace kfast {

/// How long a scene is, and which frames it has: 0 ... L-1, for `once` also L, its end.
struct Timeline {
    std::uint32_t frame_rate = 30000; ///< frames in 1000 seconds
    Time length = Time::frame(1);
    Loop loop = Loop::repeat;

    int frame_count() const;
    /// The end of `once` may lie between frames: its last frame stands at exactly L.
    Time frame_time(int frame) const;
    /// Until everything begins again: L, for ping-pong there and back.
    std::int64_t period_ticks() const;
    /// What is shown `ticks` (at least 0) after the start of playing.
    Time shown_at(std::int64_t ticks) const;
    double seconds(std::int64_t ticks) const;
};

Timeline timeline_of(const SceneView& scene);

}

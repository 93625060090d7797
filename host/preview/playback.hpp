#pragma once

#include "host/picture/timeline.hpp"
#include "host/preview/preview_key.hpp"

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace kfast {

/// Where a preview stands, apart from how it is shown. Starts playing, at the beginning, with the help open.
///
/// The caller brings the clock: `now` is any steady time. Playing follows it without adding up small steps,
/// so a slow front drops pictures instead of falling behind.
class Playback {
public:
    using Seconds = std::chrono::duration<double>;

    /// With `loops`, quits once it has played so often (a scene that plays once: one time), and shows nothing
    /// of the pass after. A stepping key begins the first pass anew.
    Playback(const Timeline& timeline, const std::vector<Time>& keys, Seconds now,
             std::optional<int> loops = std::nullopt);

    /// Stepping keys also pause, and every key but `help` closes the help.
    void press(PreviewKey key, Seconds now);
    void advance_to(Seconds now);

    Time time() const { return timeline_.shown_at(position_); }
    int frame() const { return time().ticks / Time::ticks_per_frame; }
    bool playing() const { return playing_; }
    bool help_open() const { return help_open_; }
    bool wants_to_quit() const { return wants_to_quit_; }
    /// When the next frame begins, while playing.
    Seconds next_frame_at() const;
    /// "frame 12  0.400 s  playing"
    std::string status() const;

private:
    void play_to(std::int64_t ticks);
    void toggle_playing(Seconds now);
    void stop_at(std::int64_t ticks);
    void step_frame(int direction);
    void step_key(int direction);
    std::int64_t last_step() const;

    Timeline timeline_;
    std::vector<std::int32_t> keys_; // ticks of all stops of n and p, in order, as shown
    std::int64_t position_ = 0;      // ticks since the beginning of the first pass
    std::int64_t anchor_position_ = 0;
    Seconds anchor_;                       // when playing passed anchor_position_
    std::optional<std::int64_t> quits_at_; // ticks, as position_
    bool playing_ = true;
    bool help_open_ = true;
    bool wants_to_quit_ = false;
};

}

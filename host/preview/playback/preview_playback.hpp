#pragma once

#include "host/picture/frame_source.hpp"
#include "host/picture/timeline.hpp"
#include "host/preview/board/board_clock.hpp"
#include "host/preview/controls/preview_key.hpp"
#include "host/preview/playback/playback_setup.hpp"

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace kfast {

/// How what plays is repeated.
enum class LoopChoice : std::uint8_t {
    as_authored,
    always, ///< what plays once is repeated
    once,
};

/// Where a preview stands, apart from how it is shown. Starts playing, at the beginning (backwards: at the
/// end), with the help closed.
///
/// The caller brings the clock: `now` is any steady time. Playing follows it without adding up small steps,
/// so a slow front drops pictures instead of falling behind; it passes the events all the same.
class PreviewPlayback {
public:
    using Seconds = std::chrono::duration<double>;
    using OnEvent = std::function<void(const EventView&)>;
    /// What a board takes for the picture of a moment after the one that was asked for before, in seconds.
    using BoardSeconds = std::function<double(Time)>;

    /// With `loops`, quits once it has played so often (what plays once: one time), and shows nothing of the
    /// pass after. Stepping, and another clip, let the count begin anew.
    PreviewPlayback(PlaybackSetup playback_setup, Pace pace, Seconds now,
                    std::optional<int> loops = std::nullopt);

    /// Stepping keys also pause, another clip plays, and every key but `help` closes the help.
    void press(PreviewKey key, Seconds now);
    void advance_to(Seconds now);
    /// Who hears of the events that are passed, in order; nobody at first.
    void set_on_event(OnEvent on_event) { on_event_ = std::move(on_event); }
    /// Plays as slowly as a board, from here on: what is shown are the frames that it comes to. As ever if
    /// that is empty.
    void pace_by(BoardSeconds board, Seconds now);
    /// Frames that such a board shows in a second, as of late.
    std::optional<double> board_rate() const { return board_clock_.rate(); }
    /// Pauses at this moment of the scene. One outside of the clip that plays leaves the clip.
    void scrub(Time moment);
    /// Goes on where `before` stands, a playback of the same scene as it was earlier: at its moment, on its
    /// way there or back, in its clip, with its speed and loop, its latest event, as many loops to go, and
    /// with the inputs that were turned, each as far as it is still there.
    void continue_from(const PreviewPlayback& before, Seconds now);

    /// What is to be shown.
    Time time() const { return shown_; }
    int frame() const { return shown_.ticks / Time::ticks_per_frame; }
    bool playing() const { return playing_; }
    bool help_open() const { return help_open_; }
    /// For whoever has seen it.
    void close_help() { help_open_ = false; }
    /// What is played and how fast, as it was chosen by keys.
    Timeline timeline() const { return {setup_.frame_rate, stretch(), speed_}; }
    PlayRange stretch() const;
    const Part& part() const { return setup_.parts[part_]; }
    LoopChoice loop_choice() const { return loop_choice_; }
    /// The way of a beam is to be shown where it is not lit.
    bool reveals_travel() const { return reveals_travel_; }
    bool wants_to_quit() const { return wants_to_quit_; }
    /// When the next frame begins, while playing.
    Seconds next_frame_at() const;
    /// Those of the scene.
    const std::vector<InputKnob>& inputs() const { return setup_.inputs; }
    /// The one of them that keys turn.
    std::optional<std::size_t> chosen_input() const { return input_; }
    /// "frame 12  0.400 s  playing", then what there is of the latest event as "  event step", "  speed
    /// -0.5", "  loop always", "  clip blink" and, of the input that was turned last, "  gaze 0.5".
    std::string status() const;

private:
    std::vector<Time> stops() const;
    void start_part(std::size_t part, Seconds now);
    std::int64_t before_the_end(std::int64_t ticks);
    void play(std::int64_t ticks);
    void advance_as_board(Seconds now);
    void restart_clock(Seconds now);
    void toggle_playing(Seconds now);
    void set_speed(std::int32_t speed);
    void choose_next_loop(Seconds now);
    void go_on_at(Time moment, bool playing, Seconds now);
    void continue_inputs(const PreviewPlayback& before);
    void continue_loops(const PreviewPlayback& before);
    std::int64_t way_of_a_loop() const;
    void stop_at(Time moment);
    void step_frame(int direction);
    void step_key(int direction);
    void turn_input(int steps);
    void choose_next_input();

    PlaybackSetup setup_;
    Pace pace_;
    std::optional<int> loops_;
    std::size_t part_;
    LoopChoice loop_choice_ = LoopChoice::as_authored;
    std::int32_t speed_;
    Playhead playhead_;
    Time shown_;
    Seconds anchor_;                       // when playing began or went on
    std::int64_t played_ = 0;              // ticks of the scene's clock since then
    std::optional<std::int64_t> way_left_; // to the end of the last loop: ticks of the timeline, Q16
    BoardSeconds board_;                   ///< that sets the pace; empty: none
    BoardClock board_clock_;
    OnEvent on_event_;
    std::string latest_event_;         // its name
    std::optional<std::size_t> input_; ///< that keys turn
    bool playing_ = true;
    bool help_open_ = false;
    bool reveals_travel_ = false;
    bool wants_to_quit_ = false;
};

/// What the keys made of the inputs.
void apply_inputs(InputReceiver& source, const PreviewPlayback& playback);
/// Tells `source` what the keys made of the inputs, and whether travel is revealed.
void apply_playback(FrameSource& source, const PreviewPlayback& playback);
/// The picture where `playback` stands.
const Frame& show(FrameSource& source, const PreviewPlayback& playback);

/// The clock of a preview that somebody watches.
inline PreviewPlayback::Seconds steady_now() { return std::chrono::steady_clock::now().time_since_epoch(); }

}

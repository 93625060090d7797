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

/// How playing is repeated.
enum class LoopChoice : std::uint8_t {
    as_authored,
    always, ///< what plays once is repeated
    once,
};

/// The state of a preview, apart from how it is shown. Starts playing, at the beginning (backwards: at the
/// end), with the help closed.
///
/// The caller supplies the clock: `now` is any steady time. Playing follows it without adding up small steps,
/// so a slow front drops pictures instead of falling behind; it passes the events all the same.
class PreviewPlayback {
public:
    using Seconds = std::chrono::duration<double>;
    using OnEvent = std::function<void(const EventView&)>;
    /// The seconds that a board takes for the picture at a time after the one that was asked for before.
    using BoardSeconds = std::function<double(Time)>;

    /// With `loops`, quits once it has played so often (what plays once: one time), and shows nothing of the
    /// pass after. Stepping, and another clip, let the count begin anew.
    PreviewPlayback(PlaybackSetup playback_setup, Pace pace, Seconds now,
                    std::optional<int> loops = std::nullopt);

    /// Stepping keys also pause, another clip plays, and every key but `help` closes the help.
    void press(PreviewKey key, Seconds now);
    void advance_to(Seconds now);
    /// The receiver of the events that are passed, in order; none at first.
    void set_on_event(OnEvent on_event) { on_event_ = std::move(on_event); }
    /// From now on plays as slowly as a board: the frames that it gets to are shown. At full speed if
    /// that is empty.
    void pace_by(BoardSeconds board, Seconds now);
    /// The frames that such a board has shown per second lately.
    std::optional<double> board_rate() const { return board_clock_.rate(); }
    /// Pauses at this time of the scene. A time outside of the clip that plays leaves the clip.
    void scrub(Time moment);
    /// Continues from `before`, a playback of the same scene as it was earlier: at its time, on its
    /// way there or back, in its clip, with its speed and loop, its latest event, as many loops to go, and
    /// with the inputs that were changed, each as far as it still exists.
    void continue_from(const PreviewPlayback& before, Seconds now);

    /// The time to be shown.
    Time time() const { return shown_; }
    int frame() const { return shown_.ticks / Time::ticks_per_frame; }
    bool playing() const { return playing_; }
    bool help_open() const { return help_open_; }
    /// Called when it has been seen.
    void close_help() { help_open_ = false; }
    /// What is played and how fast, as it was chosen by keys.
    Timeline timeline() const { return {setup_.frame_rate, stretch(), speed_}; }
    PlayRange stretch() const;
    const Part& part() const { return setup_.parts[part_]; }
    LoopChoice loop_choice() const { return loop_choice_; }
    /// Whether the path of a beam is to be shown where it is not lit.
    bool reveals_travel() const { return reveals_travel_; }
    bool wants_to_quit() const { return wants_to_quit_; }
    /// When the next frame begins, while playing.
    Seconds next_frame_at() const;
    /// The inputs of the scene.
    const std::vector<InputKnob>& inputs() const { return setup_.inputs; }
    /// The input that keys change.
    std::optional<std::size_t> chosen_input() const { return input_; }
    /// "frame 12  0.400 s  playing", then what there is of the latest event as "  event step", "  speed
    /// -0.5", "  loop always", "  clip blink" and, for the input that was changed last, "  gaze 0.5".
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
    Seconds anchor_;                       // when playing began or continued
    std::int64_t played_ = 0;              // ticks of the scene's time since then
    std::optional<std::int64_t> way_left_; // to the end of the last loop: ticks of the timeline, Q16
    BoardSeconds board_;                   ///< sets the pace; empty: none
    BoardClock board_clock_;
    OnEvent on_event_;
    std::string latest_event_;         // its name
    std::optional<std::size_t> input_; ///< the one that keys change
    bool playing_ = true;
    bool help_open_ = false;
    bool reveals_travel_ = false;
    bool wants_to_quit_ = false;
};

/// Sets the inputs of `source` as keys have changed them.
void apply_inputs(InputReceiver& source, const PreviewPlayback& playback);
/// Sets the inputs of `source` as keys have changed them, and whether travel is revealed.
void apply_playback(FrameSource& source, const PreviewPlayback& playback);
/// The picture at the time of `playback`.
const Frame& show(FrameSource& source, const PreviewPlayback& playback);

/// The clock of a preview with a user.
inline PreviewPlayback::Seconds steady_now() { return std::chrono::steady_clock::now().time_since_epoch(); }

}

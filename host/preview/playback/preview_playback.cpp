#include "host/preview/playback/preview_playback.hpp"

#include "host/text/characters.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace kfast {

namespace {

constexpr std::int64_t frame_ticks = Time::ticks_per_frame;
constexpr std::int32_t slowest = Playhead::as_authored / 16;

}

PreviewPlayback::PreviewPlayback(PlaybackSetup playback_setup, Pace pace, Seconds now,
                                 std::optional<int> loops)
    : setup_{std::move(playback_setup)},
      pace_{pace},
      loops_{loops},
      part_{setup_.first},
      speed_{setup_.speed},
      playhead_{timeline().playhead(setup_.events)},
      anchor_{now},
      board_clock_{timeline().seconds(frame_ticks)}
{
    start_part(part_, now);
}

void PreviewPlayback::press(PreviewKey key, Seconds now)
{
    const std::size_t parts = setup_.parts.size();
    advance_to(now);
    const bool was_help_open = std::exchange(help_open_, key == PreviewKey::help && !help_open_);
    switch (key) {
    case PreviewKey::play_pause:
        return toggle_playing(now);
    case PreviewKey::next_key:
        return step_key(1);
    case PreviewKey::previous_key:
        return step_key(-1);
    case PreviewKey::next_frame:
        return step_frame(1);
    case PreviewKey::previous_frame:
        return step_frame(-1);
    case PreviewKey::faster:
        return set_speed(2 * std::clamp(speed_, -Playhead::fastest / 2, Playhead::fastest / 2));
    case PreviewKey::slower:
        return set_speed(std::abs(speed_) < 2 * slowest ? speed_ : speed_ / 2);
    case PreviewKey::reverse:
        return set_speed(-speed_);
    case PreviewKey::loop:
        return choose_next_loop(now);
    case PreviewKey::next_clip:
        return start_part((part_ + 1) % parts, now);
    case PreviewKey::previous_clip:
        return start_part((part_ + parts - 1) % parts, now);
    case PreviewKey::next_input:
        return choose_next_input();
    case PreviewKey::more_input:
        return turn_input(1);
    case PreviewKey::less_input:
        return turn_input(-1);
    case PreviewKey::travel:
        reveals_travel_ = !reveals_travel_;
        return;
    case PreviewKey::leave:
        wants_to_quit_ = wants_to_quit_ || !was_help_open;
        return;
    case PreviewKey::quit:
        wants_to_quit_ = true;
        return;
    default: // not of the playback
        return;
    }
}

void PreviewPlayback::advance_to(Seconds now)
{
    if (!playing_)
        return;
    if (board_)
        return advance_as_board(now);
    std::int64_t ticks = std::llround((now - anchor_).count() / timeline().seconds(1));
    if (pace_ == Pace::by_frames)
        ticks -= ticks % frame_ticks;
    if (ticks < played_)
        return;
    play(ticks - std::exchange(played_, ticks));
}

void PreviewPlayback::advance_as_board(Seconds now)
{
    constexpr double longest_delay = 1; // seconds: more, as after a sleep of the computer, is left out
    if ((now - anchor_).count() - board_clock_.next() > longest_delay)
        restart_clock(now);
    while (playing_ && !wants_to_quit_ && board_clock_.is_due((now - anchor_).count())) {
        const std::int64_t ticks = board_clock_.frame() * frame_ticks;
        play(ticks - std::exchange(played_, ticks));
        board_clock_.take(board_(shown_));
    }
}

void PreviewPlayback::pace_by(BoardSeconds board, Seconds now)
{
    board_ = std::move(board);
    restart_clock(now);
}

void PreviewPlayback::restart_clock(Seconds now)
{
    anchor_ = now;
    played_ = 0;
    board_clock_.restart();
}

void PreviewPlayback::play(std::int64_t ticks)
{
    playhead_.advance(before_the_end(ticks), [this](const EventView& event) {
        latest_event_ = event.name;
        if (on_event_)
            on_event_(event);
    });
    if (!wants_to_quit_)
        shown_ = playhead_.moment();
    if (playhead_.finished()) {
        playing_ = false;
        wants_to_quit_ = wants_to_quit_ || loops_;
    }
}

/// The part of `ticks` that the last loop still has, without the end, where the pass after would begin.
std::int64_t PreviewPlayback::before_the_end(std::int64_t ticks)
{
    if (!way_left_)
        return ticks;
    const std::int64_t speed = std::abs(speed_);
    const std::int64_t max = (*way_left_ - 1) / speed;
    wants_to_quit_ = wants_to_quit_ || ticks > max;
    const std::int64_t taken = std::min(ticks, max);
    *way_left_ -= taken * speed;
    return taken;
}

PreviewPlayback::Seconds PreviewPlayback::next_frame_at() const
{
    if (board_)
        return anchor_ + Seconds{board_clock_.next()};
    return anchor_ + Seconds{timeline().seconds((played_ / frame_ticks + 1) * frame_ticks)};
}

std::string PreviewPlayback::status() const
{
    char text[96];
    std::snprintf(text, sizeof text, "frame %d  %.3f s  %s", frame(), timeline().seconds(shown_.ticks),
                  playing_ ? "playing" : "paused");
    std::string status = text;
    if (!latest_event_.empty())
        status += "  event " + visible(latest_event_);
    std::snprintf(text, sizeof text, "  speed %g", static_cast<double>(speed_) / Playhead::as_authored);
    if (speed_ != Playhead::as_authored)
        status += text;
    if (loop_choice_ != LoopChoice::as_authored)
        status += loop_choice_ == LoopChoice::always ? "  loop always" : "  loop once";
    if (part_ != 0)
        status += "  clip " + visible(setup_.parts[part_].name);
    if (input_) {
        const InputKnob& input = setup_.inputs[*input_];
        std::snprintf(text, sizeof text, " %g", input.value / 1000.0);
        status += "  " + visible(input.name) + text;
    }
    return status;
}

void PreviewPlayback::start_part(std::size_t part, Seconds now)
{
    part_ = part;
    playhead_ = timeline().playhead(setup_.events);
    stop_at(playhead_.moment());
    playing_ = true;
    restart_clock(now);
}

void PreviewPlayback::toggle_playing(Seconds now)
{
    if (!playing_ && playhead_.finished())
        return start_part(part_, now);
    playing_ = !playing_;
    restart_clock(now);
}

void PreviewPlayback::choose_next_input()
{
    const std::size_t count = setup_.inputs.size();
    std::size_t next = input_ ? *input_ + 1 : 0;
    for (std::size_t tried = 0; tried < count; ++tried, ++next)
        if (setup_.inputs[next % count].can_turn()) {
            input_ = next % count;
            return;
        }
}

void PreviewPlayback::turn_input(int steps)
{
    if (!input_)
        choose_next_input();
    if (input_)
        setup_.inputs[*input_].turn(steps);
}

void PreviewPlayback::set_speed(std::int32_t speed)
{
    speed_ = speed;
    playhead_.set_speed(speed);
}

PlayRange PreviewPlayback::stretch() const
{
    PlayRange stretch = part().stretch;
    if (loop_choice_ == LoopChoice::once)
        stretch.loop = Loop::once;
    else if (loop_choice_ == LoopChoice::always && stretch.loop == Loop::once)
        stretch.loop = Loop::repeat;
    return stretch;
}

void PreviewPlayback::choose_next_loop(Seconds now)
{
    loop_choice_ = loop_choice_ == LoopChoice::as_authored ? LoopChoice::always
                   : loop_choice_ == LoopChoice::always    ? LoopChoice::once
                                                           : LoopChoice::as_authored;
    go_on_at(shown_, playing_, now);
}

void PreviewPlayback::go_on_at(Time moment, bool playing, Seconds now)
{
    const PlayRange here = stretch();
    playhead_ = timeline().playhead(setup_.events);
    stop_at(std::clamp(moment, here.begin, here.end));
    playing_ = playing;
    restart_clock(now);
}

void PreviewPlayback::scrub(Time moment)
{
    const PlayRange here = stretch();
    if (moment < here.begin || moment > here.end)
        part_ = 0;
    go_on_at(moment, false, anchor_);
}

void PreviewPlayback::continue_inputs(const PreviewPlayback& before)
{
    for (const InputKnob& old : before.inputs()) {
        const auto same = std::ranges::find(setup_.inputs, old.name, &InputKnob::name);
        if (same == setup_.inputs.end() || !same->can_turn() || !old.can_turn())
            continue;
        if (old.is_turned)
            same->put(old.value);
        same->is_turned = old.is_turned;
        if (before.input_ && &before.setup_.inputs[*before.input_] == &old)
            input_ = static_cast<std::size_t>(same - setup_.inputs.begin());
    }
}

void PreviewPlayback::continue_from(const PreviewPlayback& before, Seconds now)
{
    const auto same = std::ranges::find(setup_.parts, before.part().name, &Part::name);
    part_ = same == setup_.parts.end() ? 0 : static_cast<std::size_t>(same - setup_.parts.begin());
    loop_choice_ = before.loop_choice_;
    speed_ = before.speed_;
    help_open_ = before.help_open_;
    reveals_travel_ = before.reveals_travel_;
    continue_inputs(before);
    const bool is_same = part().name == before.part().name && before.shown_ <= stretch().end;
    go_on_at(before.shown_, before.playing_, now);
    if (is_same && before.playhead_.returning() && stretch().loop == Loop::ping_pong)
        playhead_.seek({2 * stretch().end.ticks - before.shown_.ticks});
    latest_event_ = before.latest_event_;
    continue_loops(before);
}

std::int64_t PreviewPlayback::way_of_a_loop() const
{
    const int ways = stretch().loop == Loop::ping_pong ? 2 : 1;
    return std::int64_t{stretch().length().ticks} * Playhead::as_authored * ways;
}

/// As many whole loops are left, and of this one what is left from here on.
void PreviewPlayback::continue_loops(const PreviewPlayback& before)
{
    if (!way_left_ || !before.way_left_)
        return;
    const std::int64_t old = before.way_of_a_loop();
    const std::int64_t loop = way_of_a_loop();
    const std::int64_t whole = (*before.way_left_ - 1) / old;
    const std::int64_t rest = *before.way_left_ - whole * old;
    const bool nears_end = speed_ > 0 && !before.playhead_.returning();
    way_left_ = whole * loop + std::clamp<std::int64_t>(rest + (nears_end ? loop - old : 0), 1, loop);
}

void PreviewPlayback::stop_at(Time moment)
{
    playhead_.seek(moment);
    shown_ = moment;
    playing_ = false;
    latest_event_ = {};
    way_left_.reset();
    if (loops_ && stretch().loop != Loop::once)
        way_left_ = way_of_a_loop() * *loops_;
}

void PreviewPlayback::step_frame(int direction)
{
    const Timeline steps{setup_.frame_rate, stretch()};
    const int last = steps.frame_count() - 1;
    const int here = (shown_ - stretch().begin).ticks / Time::ticks_per_frame;
    if (direction > 0)
        return stop_at(steps.frame_time(shown_ < steps.frame_time(last) ? here + 1 : 0));
    if (shown_ == stretch().begin)
        return stop_at(steps.frame_time(last));
    stop_at(steps.frame_time(steps.frame_time(here) < shown_ ? here : here - 1));
}

/// The keys as they are shown, or the beginning where there are none.
std::vector<Time> PreviewPlayback::stops() const
{
    const auto [begin, end, loop] = stretch();
    std::vector<Time> stops;
    for (const Time key : setup_.keys)
        if (key >= begin && key <= end)
            stops.push_back(loop == Loop::repeat && key == end ? begin : key);
    if (stops.empty())
        stops.push_back(begin);
    std::ranges::sort(stops);
    return stops;
}

void PreviewPlayback::step_key(int direction)
{
    const std::vector<Time> keys = stops();
    if (direction > 0) {
        const auto next = std::ranges::upper_bound(keys, shown_);
        return stop_at(next == keys.end() ? keys.front() : *next);
    }
    const auto here = std::ranges::lower_bound(keys, shown_);
    stop_at(here == keys.begin() ? keys.back() : *std::prev(here));
}

void apply_inputs(InputReceiver& source, const PreviewPlayback& playback)
{
    for (const InputKnob& input : playback.inputs())
        if (input.range.type == InputType::text)
            source.set_text(input.number, input.text);
        else
            source.set_input(input.number, input.place());
}

void apply_playback(FrameSource& source, const PreviewPlayback& playback)
{
    source.reveal(playback.reveals_travel());
    apply_inputs(source, playback);
}

const Frame& show(FrameSource& source, const PreviewPlayback& playback)
{
    apply_playback(source, playback);
    return source.show(playback.time());
}

}

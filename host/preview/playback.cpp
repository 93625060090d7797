#include "host/preview/playback.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace kfast {
namespace {

constexpr std::int64_t frame_ticks = Time::ticks_per_frame;

/// The stops of n and p: the keys as they are shown, or the beginning where there are none.
std::vector<std::int32_t> stops(const Timeline& timeline, const std::vector<Time>& keys)
{
    std::vector<std::int32_t> ticks(std::max<std::size_t>(keys.size(), 1));
    std::ranges::transform(keys, ticks.begin(),
                           [&](Time key) { return timeline.shown_at(std::max(key.ticks, 0)).ticks; });
    std::ranges::sort(ticks);
    ticks.erase(std::unique(ticks.begin(), ticks.end()), ticks.end());
    return ticks;
}

std::int64_t ticks_of(const Timeline& timeline, int loops)
{
    return timeline.period_ticks() * (timeline.loop == Loop::once ? 1 : loops);
}

}

Playback::Playback(const Timeline& timeline, const std::vector<Time>& keys, Seconds now,
                   std::optional<int> loops)
    : timeline_{timeline}, keys_{stops(timeline, keys)}, anchor_{now}
{
    if (loops)
        quits_at_ = ticks_of(timeline, *loops);
}

void Playback::press(PreviewKey key, Seconds now)
{
    advance_to(now);
    help_open_ = key == PreviewKey::help && !help_open_;
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
    case PreviewKey::help:
        return;
    case PreviewKey::quit:
        wants_to_quit_ = true;
        return;
    }
}

void Playback::advance_to(Seconds now)
{
    if (!playing_)
        return;
    play_to(anchor_position_ + std::llround((now - anchor_).count() / timeline_.seconds(1)));
}

void Playback::play_to(std::int64_t ticks)
{
    wants_to_quit_ = wants_to_quit_ || (quits_at_ && ticks >= *quits_at_);
    if (timeline_.loop == Loop::once && ticks >= timeline_.period_ticks())
        stop_at(timeline_.period_ticks());
    else if (!wants_to_quit_)
        position_ = ticks;
}

Playback::Seconds Playback::next_frame_at() const
{
    const std::int64_t next = (position_ / frame_ticks + 1) * frame_ticks;
    return anchor_ + Seconds{timeline_.seconds(next - anchor_position_)};
}

std::string Playback::status() const
{
    char text[64];
    std::snprintf(text, sizeof text, "frame %d  %.3f s  %s", frame(), timeline_.seconds(time().ticks),
                  playing_ ? "playing" : "paused");
    return text;
}

void Playback::toggle_playing(Seconds now)
{
    playing_ = !playing_;
    const bool at_the_end = timeline_.loop == Loop::once && position_ >= timeline_.period_ticks();
    anchor_position_ = at_the_end ? 0 : position_;
    anchor_ = now;
    advance_to(now);
}

void Playback::stop_at(std::int64_t ticks)
{
    position_ = ticks;
    playing_ = false;
}

/// Where stepping back from the beginning leads.
std::int64_t Playback::last_step() const { return timeline_.frame_time(timeline_.frame_count() - 1).ticks; }

void Playback::step_frame(int direction)
{
    const std::int64_t shown = time().ticks;
    const std::int64_t last = last_step();
    if (direction > 0)
        return stop_at(shown >= last ? 0 : std::min((shown / frame_ticks + 1) * frame_ticks, last));
    stop_at(shown == 0 ? last : (shown - 1) / frame_ticks * frame_ticks);
}

void Playback::step_key(int direction)
{
    const std::int32_t shown = time().ticks;
    if (direction > 0) {
        const auto next = std::ranges::upper_bound(keys_, shown);
        return stop_at(next == keys_.end() ? keys_.front() : *next);
    }
    const auto here = std::ranges::lower_bound(keys_, shown);
    stop_at(here == keys_.begin() ? keys_.back() : *std::prev(here));
}

}
